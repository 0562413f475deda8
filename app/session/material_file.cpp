// SPDX-License-Identifier: Apache-2.0
// Material keys, with units in their names and the ranges of sim_cuda/api/params.h.
#include "app/session/material_file.h"

#include <algorithm>
#include <vector>

namespace demolish {
namespace {

/// As engine::SolidTexture has them.
const std::vector<std::string> kTextures = {"none",    "veins",  "layers", "crystals",
                                            "pebbles", "bricks", "grains"};

void readTexture(TomlReader& reader, const std::string& prefix, engine::SurfaceLook& look) {
    std::string name = kTextures[static_cast<size_t>(look.texture)];
    reader.read(prefix + "texture", name);
    const auto found = std::find(kTextures.begin(), kTextures.end(), name);
    if (found == kTextures.end()) {
        std::string all;
        for (const std::string& known : kTextures) all += (all.empty() ? "" : ", ") + known;
        reader.fail(prefix + "texture", "must be one of " + all);
    }
    look.texture = static_cast<engine::SolidTexture>(found - kTextures.begin());
}

void readFloat(TomlReader& reader, const std::string& path, float& value, const Range& range) {
    double number = value;
    reader.read(path, number, range);
    value = static_cast<float>(number);
}

}  // namespace

void readMaterial(TomlReader& reader, const std::string& prefix, Material& material) {
    reader.read(prefix + "density_kg_m3", material.density, {1, 30000});
    reader.read(prefix + "youngs_modulus_pa", material.youngs_modulus, {1e3, 1e13});
    reader.read(prefix + "tensile_strength_pa", material.tensile_strength, {1e3, 1e11});
    reader.read(prefix + "poisson_ratio", material.poisson_ratio, {0, 0.49});
    reader.read(prefix + "friction", material.friction, {0, 1.5});
    reader.read(prefix + "restitution", material.restitution, {0.05, 0.95});
    reader.read(prefix + "rolling_friction", material.rolling_friction, {0, 1});
    reader.read(prefix + "damping_ratio", material.damping_ratio, {0.05, 0.6});
    reader.read(prefix + "critical_velocity_mps", material.critical_velocity, {0.01, 1000});
    reader.read(prefix + "beta", material.beta, {0.1, 5});
    reader.read(prefix + "weibull_modulus", material.weibull_modulus, {0, 100});
    reader.read(prefix + "tough_cells", material.tough_cells, {0, 100000});
    reader.read(prefix + "tough_factor", material.tough_factor, {1, 100});
    reader.read(prefix + "adhesion_energy_j_m2", material.adhesion_energy, {0, 1000});
    reader.read(prefix + "shear_ratio", material.shear_ratio, {0, 1});
    reader.read(prefix + "grit_per_m2", material.debris.grit_per_m2, {0, 1e6});
    reader.read(prefix + "dust_m2_per_m2", material.debris.dust_m2_per_m2, {0, 10});
    reader.read(prefix + "sparks", material.debris.sparks, {0, 1});
    reader.read(prefix + "break_waves", material.break_waves, {0, 0.6});
    std::string law = material.bond_law == BondLaw::kBeam ? "beam" : "paper";
    reader.read(prefix + "bond_law", law);
    if (law != "beam" && law != "paper") reader.fail(prefix + "bond_law", "must be \"beam\" or \"paper\"");
    material.bond_law = law == "beam" ? BondLaw::kBeam : BondLaw::kPaper;
}

void readLook(TomlReader& reader, const std::string& prefix, engine::SurfaceLook& look) {
    reader.readColour(prefix + "exterior_colour", look.exterior_colour);
    reader.readColour(prefix + "interior_colour", look.interior_colour);
    reader.readColour(prefix + "dust_colour", look.dust_colour);
    readFloat(reader, prefix + "exterior_roughness", look.exterior_roughness, {0.02, 1});
    readFloat(reader, prefix + "interior_roughness", look.interior_roughness, {0.02, 1});
    readFloat(reader, prefix + "noise_strength", look.noise_strength, {0, 1});
    readFloat(reader, prefix + "relief", look.relief_height, {0, 0.15});
    readFloat(reader, prefix + "relief_size", look.relief_size, {0.1, 2});
    readFloat(reader, prefix + "crack_width_m", look.crack_width, {0, 0.1});
    readTexture(reader, prefix, look);
    readFloat(reader, prefix + "texture_size_m", look.texture_size, {1e-4, 100});
    reader.readColour(prefix + "texture_colour", look.texture_colour);
    readFloat(reader, prefix + "texture_outside", look.texture_outside, {0, 1});
    readFloat(reader, prefix + "variation", look.variation, {0, 0.9});
    readFloat(reader, prefix + "coat_m", look.coat, {0, 0.1});
    readFloat(reader, prefix + "refraction_index", look.refraction_index, {1, 2.5});
    Double3 absorption{look.absorption[0], look.absorption[1], look.absorption[2]};
    reader.read(prefix + "absorption_per_m", absorption, {0, 1e4});
    look.absorption[0] = static_cast<float>(absorption.x);
    look.absorption[1] = static_cast<float>(absorption.y);
    look.absorption[2] = static_cast<float>(absorption.z);
    readFloat(reader, prefix + "frost", look.frost, {0, 1});
}

}  // namespace demolish
