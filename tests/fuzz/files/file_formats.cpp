// SPDX-License-Identifier: Apache-2.0
// Models through assimp's exporter, texts from the assets, results from the program itself.
#include "tests/fuzz/files/file_formats.h"

#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "tests/fuzz/files/binary_fbx.h"
#include "tests/fuzz/files/picture_seeds.h"
#include "tests/fuzz/support/child_program.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/looks/look_files.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::fuzz {
namespace fs = std::filesystem;
namespace {

const fs::path kAssets = fs::path(DEMOLISH_SOURCE_DIR) / "assets";

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("could not read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& bytes) {
    fs::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    if (!out.flush()) throw std::runtime_error("could not write " + file.string());
}

/// A tiny run: the file has to be read and used, nothing has to be seen.
ReadingCommand bench(std::vector<std::string> words, std::vector<std::string> environment = {}) {
    words.insert(words.begin(), "bench");
    words.insert(words.end(),
                 {"--particles", "12", "--frames", "1", "--warmup", "0", "--no-draw", "--device", "cpu"});
    return {words, std::move(environment)};
}
/// Few substeps for what may ask for very many.
ReadingCommand shortBench(std::vector<std::string> words, std::vector<std::string> environment = {}) {
    words.insert(words.end(), {"--substeps", "10"});
    return bench(std::move(words), std::move(environment));
}

std::vector<TriangleMesh> smallMeshes() {
    return {test::makeCube(1), test::makeTorus(0.5, 0.2, 8, 6), test::makeSphere(0.5, 1)};
}

std::string offText(const TriangleMesh& mesh) {
    std::ostringstream text;
    text << "OFF\n" << mesh.positions.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (const Double3& p : mesh.positions) text << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const auto& t : mesh.triangles) text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    return text.str();
}

using Writer = std::function<std::string(const TriangleMesh&)>;

/// assimp's exporter, by its name of the format.
Writer exporter(const std::string& name, const fs::path& folder) {
    return [=](const TriangleMesh& mesh) {
        const fs::path file = folder / ("seed." + name);
        test::exportMesh(mesh, file, name);
        return bytesOf(file);
    };
}

FileFormat modelFormat(const std::string& name, const std::string& extension, const Writer& writer) {
    FileFormat format{name, {}, {}};
    for (const TriangleMesh& mesh : smallMeshes()) format.seeds.push_back(writer(mesh));
    format.place = [extension](const std::string& bytes, const fs::path& at) {
        const fs::path file = at / ("model." + extension);
        write(file, bytes);
        return bench({"--model", file.string()});
    };
    return format;
}

FileFormat pictureFormat(const std::string& name, const std::vector<std::string>& seeds) {
    return {name, seeds, [name](const std::string& bytes, const fs::path& at) {
                const fs::path file = at / ("surroundings." + name);
                write(file, bytes);
                return bench({"block", "--environment", file.string()});
            }};
}

/// Beside a cube that names it.
FileFormat textureFormat(const std::string& extension, const std::string& seed) {
    return {"texture_" + extension, {seed}, [extension](const std::string& bytes, const fs::path& at) {
                write(at / ("skin." + extension), bytes);
                write(at / "cube.mtl", "newmtl skin\nmap_Kd skin." + extension + "\n");
                write(at / "cube.obj", test::cubeObj("cube.mtl"));
                return bench({"--model", (at / "cube.obj").string()});
            }};
}

/// A picture and all that a material can say, in one file.
FileFormat texturedGlbFormat() {
    const std::string material =
        R"({"alphaMode":"MASK","emissiveFactor":[1,0,0],"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":0},"occlusionTexture":{"index":0}})";
    const std::string glb = test::cubeGlb(material, test::pngOf(2, 2, test::fourTexels()), true);
    return {"glb_textured", {glb}, [](const std::string& bytes, const fs::path& at) {
                write(at / "model.glb", bytes);
                return bench({"--model", (at / "model.glb").string()});
            }};
}

std::vector<std::string> assetTexts(const std::string& kind) {
    std::vector<std::string> texts;
    for (const auto& entry : fs::directory_iterator(kAssets / kind))
        if (entry.path().extension() == ".toml") texts.push_back(bytesOf(entry.path()));
    return texts;
}

/// The program's assets with one file more, or another one.
ReadingCommand withAsset(const std::string& bytes, const std::string& name, const fs::path& folder,
                         const std::vector<std::string>& words) {
    const fs::path own = folder / "assets";
    for (const char* kind : {"models", "scenes", "materials", "strength"}) {
        fs::create_directories(own / kind);
        for (const auto& entry : fs::directory_iterator(kAssets / kind)) {
            const fs::path link = own / kind / entry.path().filename();
            if (!fs::exists(link)) fs::create_symlink(entry.path(), link);
        }
    }
    fs::remove(own / name);
    write(own / name, bytes);
    return shortBench(words, {"DEMOLISH_DATA=" + folder.string()});
}

FileFormat assetFormat(const std::string& name, const std::string& kind, const std::string& file,
                       const std::vector<std::string>& words) {
    return {name, assetTexts(kind),
            [=](const std::string& bytes, const fs::path& folder) {
                return withAsset(bytes, kind + "/" + file, folder, words);
            },
            true};
}

FileFormat experimentFormat() {
    return {"experiment", assetTexts("experiments"), [](const std::string& bytes, const fs::path& folder) {
                for (const auto& entry : fs::directory_iterator(kAssets / "experiments"))
                    fs::create_symlink(entry.path(), folder / entry.path().filename());
                const fs::path file = folder / "damaged.toml";
                write(file, bytes);
                return ReadingCommand{{"breakage", file.string(), "--count"}, {}};
            }};
}

void runOrThrow(const std::vector<std::string>& words, const std::vector<std::string>& environment = {}) {
    std::vector<std::string> all = {test::programPath()};
    all.insert(all.end(), words.begin(), words.end());
    const ChildEnd end = runChild(all, {.seconds = 600}, environment);
    if (!end.endedWith(0)) throw std::runtime_error(commandLine(all) + ": " + describe(end) + "\n" + end.err);
}

/// A folder of results with one file of it replaced; gathered without PNG, which takes another program.
FileFormat resultFormat(const std::string& name, const std::string& file, const fs::path& folder) {
    const fs::path results = folder / "breakage";
    if (!fs::exists(results / file)) {
        write(folder / "tiny.toml",
              "[specimen]\ngrains = 40\npackings = 2\n[impact]\nslowest_mps = 10\nfastest_mps = 90\n"
              "velocities = 2\nduration_s = 40e-9\n");
        runOrThrow({"breakage", (folder / "tiny.toml").string(), "--device", "cpu", "--full", "--out",
                    results.string()});
    }
    return {
        name, {bytesOf(results / file)}, [=](const std::string& bytes, const fs::path& at) {
            fs::copy(results, at / "out", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
            write(at / "out" / file, bytes);
            return ReadingCommand{{"breakage", "gather", "--out", (at / "out").string()}, {"PATH=/nowhere"}};
        }};
}

/// What calibrate keeps for the next time, found again by the file's name.
FileFormat cacheFormat(const fs::path& folder) {
    const std::vector<std::string> shot = {"block", "--particles", "12", "--substeps",
                                           "10",    "--device",    "cpu"};
    std::vector<std::string> calibrate = shot;
    calibrate.insert(calibrate.begin(), "calibrate");
    runOrThrow(calibrate, {"XDG_CACHE_HOME=" + (folder / "cache").string()});
    const fs::path kept = *fs::directory_iterator(folder / "cache/demolish/thresholds");
    return {"threshold", {bytesOf(kept)}, [kept](const std::string& bytes, const fs::path& at) {
                write(at / "cache/demolish/thresholds" / kept.filename(), bytes);
                return shortBench({"block", "--mesh", "fine", "--break-at", "20"},
                                  {"XDG_CACHE_HOME=" + (at / "cache").string()});
            }};
}

}  // namespace

std::vector<FileFormat> fileFormats(const fs::path& folder) {
    fs::create_directories(folder);
    return {modelFormat("obj", "obj", [](const TriangleMesh& mesh) { return test::objText(mesh); }),
            modelFormat("off", "off", offText),
            modelFormat("ply", "ply", exporter("ply", folder)),
            modelFormat("ply_binary", "ply", exporter("plyb", folder)),
            modelFormat("stl", "stl", exporter("stl", folder)),
            modelFormat("stl_binary", "stl", exporter("stlb", folder)),
            modelFormat("glb", "glb", exporter("glb2", folder)),
            modelFormat("fbx", "fbx", exporter("fbxa", folder)),
            modelFormat("fbx_binary", "fbx", binaryFbx),
            pictureFormat("hdr", hdrSeeds()),
            pictureFormat("exr", exrSeeds(folder)),
            textureFormat("png", test::pngOf(2, 2, test::fourTexels())),
            textureFormat("tga", test::tgaOf(2, 2, test::fourTexels())),
            texturedGlbFormat(),
            assetFormat("scene", "scenes", "damaged.toml", {"damaged"}),
            assetFormat("material", "materials", "damaged.toml", {"block", "--material", "damaged"}),
            assetFormat("strength", "strength", "thresholds.toml",
                        {"--model", (kAssets / "models/block.obj").string()}),
            experimentFormat(),
            resultFormat("plan", "plan.json", folder),
            resultFormat("item", "items/item_00000.json", folder),
            cacheFormat(folder)};
}

}  // namespace demolish::fuzz
