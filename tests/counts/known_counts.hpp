#pragma once
/// \file
/// The rows of known_counts.tsv: object, size, count, source, second method.

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hexatlas::counts {

/// The counts of one object by size. Throws if the file has none.
inline std::map<int, std::uint64_t> known(const std::string& object) {
  std::map<int, std::uint64_t> result;
  std::ifstream file(HEXATLAS_SOURCE_DIR "/tests/counts/known_counts.tsv");
  for (std::string line; std::getline(file, line);) {
    std::istringstream row(line);
    std::string name;
    int size = 0;
    std::uint64_t count = 0;
    if (line.starts_with("#") || !std::getline(row, name, '\t') || name != object) continue;
    if (!(row >> size >> count)) throw std::runtime_error("a row of known_counts.tsv is malformed");
    result[size] = count;
  }
  if (result.empty()) throw std::runtime_error("known_counts.tsv has no rows for " + object);
  return result;
}

/// Those of sizes in [from, to].
inline std::map<int, std::uint64_t> known(const std::string& object, int from, int to) {
  auto result = known(object);
  std::erase_if(result, [&](const auto& row) { return row.first < from || row.first > to; });
  return result;
}

}  // namespace hexatlas::counts
