// SPDX-License-Identifier: Apache-2.0
// What a damaged file has put into an error comes out as one line of plain text.
#include "app/commands/one_sentence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demolish {
namespace {

TEST(OneSentence, PlainTextStaysAsItIs) {
    EXPECT_EQ(oneSentence("scene.toml:3: 'height_m' is wrong"), "scene.toml:3: 'height_m' is wrong");
    EXPECT_EQ(oneSentence("модель Ωμέγα 模型 🗿.obj"), "модель Ωμέγα 模型 🗿.obj");
    EXPECT_EQ(oneSentence(""), "");
}

TEST(OneSentence, LineEndsAndControlCharactersBecomeBlanks) {
    EXPECT_EQ(oneSentence("a\nb\tc\x1b[31m\x7f"), "a b c [31m ");
    EXPECT_EQ(oneSentence(std::string("a\0b", 3)), "a b");
}

TEST(OneSentence, BytesThatAreNoLettersBecomeQuestionMarks) {
    EXPECT_EQ(oneSentence("a\xff\xfe"), "a??");
    EXPECT_EQ(oneSentence("a\xc3"), "a?") << "cut within a letter";
    EXPECT_EQ(oneSentence("\x80z"), "?z");
}

TEST(OneSentence, OfLongTextBeginningAndEndAreKept) {
    const std::string text = "file.stl: " + std::string(40000, '(') + "; remove it";
    const std::string line = oneSentence(text);
    EXPECT_LE(line.size(), 1010u);
    EXPECT_THAT(line, testing::StartsWith("file.stl: (("));
    EXPECT_THAT(line, testing::HasSubstr(" ... "));
    EXPECT_THAT(line, testing::EndsWith("((; remove it"));
    std::string wide;
    for (int k = 0; k < 900; ++k) wide += "ж";
    EXPECT_EQ(oneSentence(wide).find('?'), std::string::npos) << "no letter is cut";
}

}  // namespace
}  // namespace demolish
