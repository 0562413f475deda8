// How golden pictures are looked up, compared and reported.
#pragma once
#include <filesystem>
#include <string>

namespace demolish::engine::test {

/// Set by --update-goldens: pictures are accepted instead of compared.
inline bool update_goldens = false;

}  // namespace demolish::engine::test
