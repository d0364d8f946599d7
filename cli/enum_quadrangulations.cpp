#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdint>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "enum/canon/code.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/quads/generate.hpp"
#include "enum/quads/planar_code.hpp"

namespace hexatlas::cli {
namespace {

/// Each shard is cut into this many parts, whatever the number of threads, so that the order of a
/// list does not depend on it.
constexpr std::uint64_t kParts = 32;

struct Found {
  quads::Sums sums;
  std::string list;  ///< without header; empty if not asked for
};

quads::Class class_named(const std::string& name) {
  if (name == "simple") return quads::Class::simple;
  if (name == "min-degree-3") return quads::Class::min_degree_3;
  core::expects(name == "3-connected", "there is no such class of quadrangulations");
  return quads::Class::three_connected;
}

quads::Shard shard_of(const EnumQuadrangulationsOptions& options) {
  return options.shard.empty() ? quads::Shard{} : shard_from(options.shard).value();
}

Found part_of(const EnumQuadrangulationsOptions& options, std::uint64_t part,
              const std::atomic<bool>& stop) {
  Found found;
  quads::Visit visit;
  if (!options.output.empty())
    visit = [&found, &options](const complex::Quadrangulation& q, int, int) {
      if (options.codes)
        found.list += canon::to_text(canon::canonical_form(q).code) + "\n";
      else
        quads::append_planar_code(q, found.list);
    };
  const quads::Shard shard = shard_of(options);
  found.sums = quads::generate(
      class_named(options.class_name), options.quads, visit,
      {.shard = {shard.part + shard.parts * part, shard.parts * kParts}, .stop = &stop});
  return found;
}

Found find(const EnumQuadrangulationsOptions& options) {
  const std::atomic<bool>& stop = stop_requested();
  ProgressLine progress;
  std::mutex progress_lock;
  std::size_t done = 0;
  std::vector<Found> parts(kParts);
  parallel::parallel_for(parallel::threads_or_all(options.threads), kParts, [&](std::size_t i) {
    parts[i] = part_of(options, i, stop);
    const std::lock_guard lock(progress_lock);
    progress.update("parts of the search", ++done, kParts);
  });
  Found all;
  if (!options.output.empty() && !options.codes) all.list = quads::kPlanarCodeHeader;
  for (Found& part : parts) {
    all.sums += part.sums;
    all.list += part.list;
    part = {};
  }
  return all;
}

bool is_whole(const EnumQuadrangulationsOptions& options) { return shard_of(options).parts == 1; }

std::string json_line(const EnumQuadrangulationsOptions& options, const quads::Sums& sums) {
  nlohmann::ordered_json json;
  json["quads"] = options.quads;
  json["class"] = options.class_name;
  json["count"] = sums.classes;
  json["orientation_preserving"] = sums.orientation_preserving;
  json["rooted_sum"] = sums.rooted;
  if (!options.shard.empty()) json["shard"] = options.shard;
  json["exhaustive"] = is_whole(options);
  return to_line(json);
}

std::string report(const EnumQuadrangulationsOptions& options, const quads::Sums& sums) {
  return fmt::format(
      "{} quadrangulations of the sphere with {} quads{}: {}\n"
      "{} with mirror images told apart; rooted sum {}{}\n",
      options.class_name, options.quads,
      is_whole(options) ? "" : ", part " + options.shard + " of the list", sums.classes,
      sums.orientation_preserving, sums.rooted,
      is_whole(options) ? "; the search is exhaustive" : "");
}

}  // namespace

std::optional<quads::Shard> shard_from(const std::string& text) {
  constexpr std::uint64_t kMostParts = 1'000'000;
  quads::Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, part_error] = std::from_chars(text.data(), end, shard.part);
  if (part_error != std::errc{} || slash == end || *slash != '/') return std::nullopt;
  const auto [last, parts_error] = std::from_chars(slash + 1, end, shard.parts);
  if (parts_error != std::errc{} || last != end) return std::nullopt;
  if (shard.part >= shard.parts || shard.parts > kMostParts) return std::nullopt;
  return shard;
}

ExitCode enum_quadrangulations(const EnumQuadrangulationsOptions& options) {
  if (!options.output.empty()) core::expect_writable(options.output);
  const Found found = find(options);
  if (!found.sums.complete) {
    say(options.output.empty() ? "stopped; there is no total" : "stopped; nothing is written");
    return ExitCode::undecided;
  }
  if (!options.output.empty()) core::write_file(options.output, found.list);
  const std::string text =
      options.json ? json_line(options, found.sums) : report(options, found.sums);
  tell(options.output, text);
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
