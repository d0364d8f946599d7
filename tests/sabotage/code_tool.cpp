/// \file
/// Prints the canonical codes of quadrangulations, one per line of standard input: the vertices of
/// the quads one after another. For reference_code.py.

#include <iostream>
#include <sstream>
#include <string>

#include "tables/check/quad_code.hpp"

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream numbers(line);
    std::vector<hexatlas::check::Quad> quads;
    for (hexatlas::check::Quad quad{}; numbers >> quad[0] >> quad[1] >> quad[2] >> quad[3];) {
      quads.push_back(quad);
    }
    const auto code = hexatlas::check::canonical_code(quads);
    std::cout << (code ? hexatlas::check::code_text(code->word) : "none") << '\n';
  }
  return 0;
}
