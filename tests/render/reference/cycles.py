# SPDX-License-Identifier: Apache-2.0
# Path-traces a folder that writeShot() (reference_shot.h) has filled: its pieces, camera, sun, surroundings and
# floor, in Blender's Cycles on the CPU, to cycles.png. Run by Blender: -- FOLDER SAMPLES
import json
import math
import os
import sys

import bpy
from mathutils import Vector

FOLDER, SAMPLES = sys.argv[sys.argv.index("--") + 1:][:2]
with open(os.path.join(FOLDER, "scene.json"), encoding="utf-8") as file:
    SCENE = json.load(file)


def principled(material, colour, roughness, metal=0.0):
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metal
    return shader


def glass(material, look, frost):
    """Absorbs exp(-absorption d); `frost`: the share of its light that a broken face scatters."""
    tree = material.node_tree
    shader = principled(material, (1, 1, 1), math.sqrt(frost) * 0.5)
    shader.inputs["Transmission"].default_value = 1
    shader.inputs["IOR"].default_value = look["refraction_index"]
    most = max(look["absorption"])
    if most > 0:
        volume = tree.nodes.new("ShaderNodeVolumeAbsorption")
        volume.inputs["Density"].default_value = most
        volume.inputs["Color"].default_value = (*(1 - a / most for a in look["absorption"]), 1)
        tree.links.new(volume.outputs[0], tree.nodes["Material Output"].inputs["Volume"])


def add_pieces():
    bpy.ops.wm.obj_import(filepath=os.path.join(FOLDER, "pieces.obj"), forward_axis="Y", up_axis="Z")
    look = SCENE["look"]
    for name in ("outside", "inside"):
        material = bpy.data.materials.get(name)
        if material is None:
            continue
        if look["refraction_index"] > 1:
            material.use_nodes = True
            glass(material, look, look["frost"] if name == "inside" else 0.0)
        else:
            principled(material, look[name], look[name + "_roughness"])


def add_rest():
    bpy.ops.mesh.primitive_plane_add(size=400)
    floor = bpy.data.materials.new("floor")
    principled(floor, SCENE["floor"], 0.62)
    bpy.context.object.data.materials.append(floor)
    iron = bpy.data.materials.new("iron")
    principled(iron, (0.23, 0.215, 0.205), 0.36, 1.0)  # shaders/common/ball_material.glsl
    for ball in SCENE["balls"]:
        bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=ball["radius"], location=ball["at"])
        bpy.ops.object.shade_smooth()
        bpy.context.object.data.materials.append(iron)


def add_light():
    sun = bpy.data.lights.new("sun", "SUN")
    most = max(SCENE["sun_colour"])
    sun.color = [c / most for c in SCENE["sun_colour"]]
    sun.energy = math.pi * most  # so that a white surface facing it shines with sun_colour
    sun.angle = 2 * math.atan(SCENE["sun_tangent"])
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_euler = Vector(SCENE["sun_direction"]).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(lamp)
    world = bpy.data.worlds.new("surroundings")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(os.path.join(FOLDER, "surroundings.exr"))
    turn, place = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexCoord")
    turn.inputs["Rotation"].default_value = (0, 0, -math.pi / 2)  # our middle column looks along +y, Blender's along +x
    links.new(place.outputs["Generated"], turn.inputs["Vector"])
    links.new(turn.outputs[0], picture.inputs[0])
    links.new(picture.outputs[0], nodes["Background"].inputs["Color"])


def add_camera():
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL" if SCENE["width"] >= SCENE["height"] else "HORIZONTAL"
    camera.angle = SCENE["field_of_view"]
    camera.clip_start, camera.clip_end = 0.01, 1000
    eye = bpy.data.objects.new("camera", camera)
    eye.location = SCENE["eye"]
    eye.rotation_euler = (Vector(SCENE["target"]) - Vector(SCENE["eye"])).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(eye)
    bpy.context.scene.camera = eye


def render():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = int(SAMPLES)
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = SCENE["width"], SCENE["height"]
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.exposure = math.log2(SCENE["exposure"])
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.join(FOLDER, "cycles.png")
    bpy.ops.render.render(write_still=True)


bpy.ops.wm.read_factory_settings(use_empty=True)
add_pieces()
add_rest()
add_light()
add_camera()
render()
