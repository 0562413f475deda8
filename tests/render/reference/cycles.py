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


def glass(look):
    """Absorbs exp(-absorption d); broken faces scatter a share of their light (frost), which is their roughness here."""
    material = bpy.data.materials.new("glass")
    shader = principled(material, (1, 1, 1), 0.0)
    shader.inputs["Transmission"].default_value = 1
    shader.inputs["IOR"].default_value = look["refraction_index"]
    nodes, links = material.node_tree.nodes, material.node_tree.links
    broken, rough = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeMath")
    broken.attribute_name, rough.operation = "broken", "MULTIPLY"
    rough.inputs[1].default_value = math.sqrt(look["frost"]) * 0.5
    links.new(broken.outputs["Fac"], rough.inputs[0])
    links.new(rough.outputs[0], shader.inputs["Roughness"])
    most = max(look["absorption"])
    if most > 0:
        volume = nodes.new("ShaderNodeVolumeAbsorption")
        volume.inputs["Density"].default_value = most
        volume.inputs["Color"].default_value = (*(1 - a / most for a in look["absorption"]), 1)
        links.new(volume.outputs[0], nodes["Material Output"].inputs["Volume"])
    return material


def make_glass(mesh, material):
    """One material all round: a ray that goes in by one and comes out by another stays in the first one's volume."""
    broken = mesh.attributes.new("broken", "FLOAT", "FACE")
    names = [slot.name for slot in mesh.materials]
    for face, value in zip(mesh.polygons, broken.data):
        value.value = float(names[face.material_index] == "inside")
        face.material_index = 0
    mesh.materials.clear()
    mesh.materials.append(material)


def add_pieces():
    bpy.ops.wm.obj_import(filepath=os.path.join(FOLDER, "pieces.obj"), forward_axis="Y", up_axis="Z")
    look = SCENE["look"]
    if look["refraction_index"] > 1:
        material = glass(look)
        for piece in bpy.context.selected_objects:
            make_glass(piece.data, material)
        return
    for name in ("outside", "inside"):
        material = bpy.data.materials.get(name)
        if material is not None:
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
    # Light is mirrored inside of glass many times; Blender's own limit of 4 leaves it black.
    for kind in ("max", "diffuse", "glossy", "transmission", "volume"):
        setattr(scene.cycles, kind + "_bounces", 64)
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
