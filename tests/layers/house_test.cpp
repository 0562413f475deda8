// SPDX-License-Identifier: Apache-2.0
// What holds for every source file: its first line, its length, that of its functions; and habits that would
// break the equal bits of CPU and GPU, or let threads of one program meet on CUDA's legacy stream.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/layers/source_tree.h"

namespace demolish::layers {
namespace {

const std::vector<std::string> kAllFolders = {"sim_cuda", "engine", "app", "assets", "tests"};
constexpr size_t kMostFileLines = 400, kMostFunctionLines = 60;

struct Block {
    size_t line = 0, lines = 0;
    std::string head;
};

/// Blocks in braces behind a pair of parentheses, by their lines: functions, and what is within them.
std::vector<Block> functionsIn(const std::string& code) {
    static const std::regex kNoFunction(R"(^\s*(namespace|class|struct|enum|union)\b)");
    std::vector<Block> open, functions;
    size_t line = 1, head = 0;
    for (size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        if (c == '\n') ++line;
        if (c == '{') open.push_back({line, 0, code.substr(head, i - head)});
        if (c == '}' && !open.empty()) {
            Block block = open.back();
            open.pop_back();
            block.lines = line - block.line + 1;
            if (block.head.find(')') != std::string::npos && !std::regex_search(block.head, kNoFunction))
                functions.push_back(block);
        }
        if (c == '{' || c == '}' || c == ';') head = i + 1;
    }
    return functions;
}

/// Calls that go to the legacy stream, which waits for all other streams and ends what they record.
const std::vector<std::regex> kLegacyStream = {
    std::regex(R"(\bcudaMem(cpy|set)(2D|3D)?(ToSymbol|FromSymbol)?\s*\()"),
    std::regex(R"(\bcudaStreamCreate\s*\()"),
    std::regex(R"(\bcudaStreamCreateWith(Flags|Priority)\s*\((?![^;]*cudaStreamNonBlocking)[^;]*;)"),
    std::regex(R"(\bcudaStream(Synchronize|Query)\s*\(\s*(0|nullptr|NULL|\{\})\s*\))"),
    std::regex(R"(\b(cudaMem(cpy|set)\w*Async|cudaGraphics(Map|Unmap)Resources|cudaEventRecord)\s*)"
               R"(\([^;]*,\s*(0|nullptr|NULL|\{\})\s*\))"),
    std::regex(R"(\bcudaGraphics(Map|Unmap)Resources\s*\([^,;]*,[^,;()]*(\([^()]*\))?\s*\))"),
    std::regex(R"(\bcudaEventRecord\s*\([^,;]*\))"),
    std::regex(R"(\bcudaStreamLegacy\b)"),
    std::regex(R"(<<<[^;,]*,[^;,]*(,[^;,]*)?>>>)"),
    std::regex(R"(<<<[^;]*,\s*(0|nullptr|NULL)\s*>>>\s*\()"),
};

/// The first such call, or "".
std::string legacyStreamIn(const std::string& code) {
    std::smatch match;
    if (code.find("cuda") == std::string::npos && code.find("<<<") == std::string::npos) return "";
    for (const std::regex& call : kLegacyStream)
        if (std::regex_search(code, match, call)) return match.str();
    return "";
}

}  // namespace

TEST(House, FilesBeginWithTheirLicense) {
    const auto files = sourcesUnder(kAllFolders);
    ASSERT_GT(files.size(), 200u);
    for (const auto& file : files) {
        const auto lines = linesOf(file);
        EXPECT_EQ(lines.empty() ? "" : lines[0], "// SPDX-License-Identifier: Apache-2.0") << nameOf(file);
    }
}

TEST(House, FilesAndFunctionsStayShort) {
    for (const auto& file : sourcesUnder(kAllFolders)) {
        EXPECT_LE(linesOf(file).size(), kMostFileLines) << nameOf(file);
        for (const Block& function : functionsIn(codeOfFile(file)))
            EXPECT_LE(function.lines, kMostFunctionLines) << nameOf(file) << ":" << function.line;
    }
}

TEST(House, NothingBreaksTheEqualBits) {
    const std::regex habits(
        R"(use_fast_math|ffast-math|atomicAdd\s*\(\s*\(?\s*float|\bfminf\b|\bfmaxf\b|\brsqrtf\b|__sinf|__expf)");
    for (const auto& file : sourcesUnder({"sim_cuda"})) {
        const auto lines = linesOf(file);
        for (size_t i = 0; i < lines.size(); ++i) {
            const auto code = lines[i].substr(0, lines[i].find("//"));
            EXPECT_FALSE(std::regex_search(code, habits)) << nameOf(file) << ":" << i + 1;
        }
    }
}

TEST(House, NothingGoesToTheLegacyStream) {
    for (const auto& file : sourcesUnder({"sim_cuda", "app/bridge"}))
        EXPECT_EQ(legacyStreamIn(codeOfFile(file)), "") << nameOf(file);
}

/// Names of the app's files whose code matches, but for those that begin so.
std::vector<std::string> othersThat(const std::regex& habit, const std::string& place) {
    std::vector<std::string> names;
    for (const auto& file : sourcesUnder({"app"}))
        if (!nameOf(file).starts_with(place) && std::regex_search(codeOfFile(file), habit))
            names.push_back(nameOf(file));
    return names;
}

TEST(House, WhatHasItsPlaceIsDoneThereAlone) {
    const std::vector<std::string> none;
    const std::regex model_file(R"(\b(loadSolidMesh|importTriangles|importModels?|importSet)\s*\()");
    const std::regex json(R"(\.dump\()");
    const std::regex child(R"(\b(posix_spawnp?|fork|popen|system|waitpid|wait4)\s*\()");
    EXPECT_EQ(othersThat(model_file, "app/reading/"), none) << "untrusted input";
    EXPECT_EQ(othersThat(json, "app/session/json_text."), none) << "throws where a name is no UTF-8";
    EXPECT_EQ(othersThat(child, "app/process/"), none) << "use a ChildProcess";
    for (const auto& [habit, place] :
         {std::pair{model_file, "app/reading/"}, {json, "app/session/json_text."}, {child, "app/process/"}})
        EXPECT_NE(othersThat(habit, "no/such/place"), none) << place;
}

TEST(House, TheRulesThemselvesCatchWhatTheyForbid) {
    std::string body;
    for (int line = 0; line < 60; ++line) body += "    step();\n";
    const auto functions =
        functionsIn(codeOf("// {\nvoid run(int n) {\n" + body + "}\n\nint one() { return 1'000; }\n"));
    ASSERT_EQ(functions.size(), 2u);
    EXPECT_EQ(functions[0].line, 2u);
    EXPECT_EQ(functions[0].lines, 62u);
    EXPECT_EQ(functions[1].lines, 1u);
    EXPECT_EQ(codeOf("a /* b\n */ c // d\n#define E \\\n f\n\"g{\" '{'"), "a \n c \n\n\n\"\" ''");

    for (const char* call :
         {"cudaMemcpy(to, from, n, cudaMemcpyHostToDevice);", "cudaMemset (at, 0, n);",
          "cudaStreamCreate(&stream);", "cudaStreamCreateWithFlags(&stream, cudaStreamDefault);",
          "cudaStreamSynchronize(nullptr);", "cudaMemcpyAsync(to, from, n, cudaMemcpyHostToDevice, 0);",
          "cudaGraphicsMapResources(1, &resource);",
          "cudaGraphicsMapResources(static_cast<int>(n), all.data(),\n    nullptr);",
          "cudaGraphicsUnmapResources(1, &resource, 0);", "run<<<blocks, threads>>>(n);",
          "run<<<blocks, threads, 0, 0>>>(n);"})
        EXPECT_NE(legacyStreamIn(call), "") << call;
    for (const char* call :
         {"cudaMemcpyAsync(to, from, n, cudaMemcpyHostToDevice, stream_);",
          "cudaMemsetAsync(at, 0, n, stream_);", "cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);",
          "cudaStreamSynchronize(stream);",
          "cudaGraphicsMapResources(static_cast<int>(n), all.data(), stream_);",
          "run<<<blocks, 32, 0, stream()>>>(n);"})
        EXPECT_EQ(legacyStreamIn(call), "");
}

}  // namespace demolish::layers
