#include "enum/core/rank.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace hexatlas::core {

std::size_t rank_modulo_2(std::vector<std::vector<std::size_t>> rows) {
  std::map<std::size_t, std::vector<std::size_t>> with_pivot;
  for (std::vector<std::size_t>& row : rows) {
    while (!row.empty()) {
      const auto [place, is_new] = with_pivot.try_emplace(row.front(), row);
      if (is_new) break;
      std::vector<std::size_t> sum;
      std::set_symmetric_difference(row.begin(), row.end(), place->second.begin(),
                                    place->second.end(), std::back_inserter(sum));
      row = std::move(sum);
    }
  }
  return with_pivot.size();
}

}  // namespace hexatlas::core
