// SPDX-License-Identifier: Apache-2.0
// demolish_sculptor RECIPE.toml --triangles N --out FILE.obj
#include <CLI/CLI.hpp>
#include <cstdio>

#include "assets/models/sculpt.h"

int main(int argc, char** argv) {
    using namespace demolish::sculptor;
    CLI::App app("Makes a closed triangle mesh out of a recipe.");
    std::string recipe_file, out_file;
    std::size_t triangles = 0;
    app.add_option("recipe", recipe_file, "Recipe (TOML)")->required()->check(CLI::ExistingFile);
    app.add_option("--triangles", triangles, "Exact number of triangles, even")->required();
    app.add_option("--out", out_file, "Mesh to write (OBJ, metres)")->required();
    CLI11_PARSE(app, argc, argv);
    try {
        const Model model = sculpt(readRecipe(recipe_file), triangles);
        writeText(out_file, objText(model, std::filesystem::path(recipe_file).stem().string()));
        std::printf("%s: %zu triangles, %zu positions, %.6f m3\n", out_file.c_str(),
                    model.surface.triangles.size(), model.surface.positions.size(), volumeOf(model.surface));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "demolish_sculptor: %s\n", error.what());
        return 1;
    }
    return 0;
}
