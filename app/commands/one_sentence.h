// SPDX-License-Identifier: Apache-2.0
// What is said of a failure, whatever a file or a library has put into it.
#pragma once
#include <string>

namespace demolish {

/// One line of plain text: line ends and other control characters become blanks, bytes that are no UTF-8
/// question marks, and of more than 1,000 bytes the middle is left out.
std::string oneSentence(const std::string& text);

}  // namespace demolish
