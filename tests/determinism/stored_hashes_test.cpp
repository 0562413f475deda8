// SPDX-License-Identifier: Apache-2.0
// The CPU gives the stored bits: 2,000 breaking substeps, in the same file that the GPU is checked against.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/determinism/stored_hashes.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/set_scenes.h"

namespace demolish::tests {
namespace {

std::vector<std::string> runOnCpu(const SceneSetup& setup, uint32_t& broken) {
    auto solver = makeCpuSolver(setup);
    std::vector<std::string> hashes;
    for (const uint64_t hash : hashesOf(*solver)) hashes.push_back(asHex(hash));
    broken = solver->stats().bonds_broken;
    return hashes;
}

void checkStored(const std::string& name, const SceneSetup& setup, uint32_t least_broken = 300) {
    uint32_t broken = 0;
    const auto hashes = runOnCpu(setup, broken);
    EXPECT_GT(broken, least_broken);
    if (std::getenv("DEMOLISH_UPDATE_HASHES") != nullptr) storeHashes(name, hashes);
    EXPECT_EQ(hashes, storedHashes(name));
}

TEST(StoredHashes, LinearContacts) {
    checkStored("breaking_brick", breakingScene());
}

TEST(StoredHashes, HertzContactsAndThePapersBondLaw) {
    SceneSetup setup = breakingScene();
    setup.params.contact_law = ContactLaw::kHertz;
    setup.bodies[0].material.bond_law = BondLaw::kPaper;
    setup.bodies[0].material.adhesion_energy = 0.1;
    checkStored("breaking_brick_paper", setup);
}

TEST(StoredHashes, WhatIsHeldAndLed) {
    checkStored("held_and_led", heldScene(), 30);
}

TEST(StoredHashes, UnlikeBodiesInMortar) {
    checkStored("mortar", mortarScene(), 30);
}

TEST(StoredHashes, UnlikeBodiesThatBeginAgainstEachOther) {
    checkStored("dry", dryScene(), 30);
}

}  // namespace
}  // namespace demolish::tests
