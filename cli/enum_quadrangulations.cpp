#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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

/// The parts as they end, of which those that are next go to a file.
class Parts {
 public:
  explicit Parts(const core::Sink& sink) : sink_(sink), found_(kParts) {}

  [[nodiscard]] quads::Sums found(const EnumQuadrangulationsOptions& options) {
    const std::atomic<bool>& stop = stop_requested();
    parallel::parallel_for(parallel::threads_or_all(options.threads), kParts, [&](std::size_t i) {
      if (has_failed_) return;
      Found part;
      try {
        part = part_of(options, i, stop);
      } catch (...) {
        has_failed_ = true;
        throw;
      }
      const std::lock_guard lock(lock_);
      if (has_failed_) return;
      found_[i] = std::move(part);
      progress_.update("parts of the search", ++done_, kParts);
      put_next();
    });
    return sums_;
  }

 private:
  void put_next() {
    for (; next_ < kParts && found_[next_]; ++next_) {
      sums_ += found_[next_]->sums;
      if (sums_.complete) put(found_[next_]->list);
      found_[next_] = Found{};
    }
  }

  void put(const std::string& list) {
    try {
      sink_(list);
    } catch (...) {
      has_failed_ = true;
      throw;
    }
  }

  const core::Sink& sink_;
  ProgressLine progress_;
  std::mutex lock_;
  std::vector<std::optional<Found>> found_;
  std::size_t done_ = 0, next_ = 0;
  quads::Sums sums_;
  std::atomic<bool> has_failed_{false};  ///< then nothing more is begun or written
};

struct Stopped {};

/// The list goes to the output, if there is one, as it is found. Throws Stopped.
quads::Sums list_to_output(const EnumQuadrangulationsOptions& options) {
  quads::Sums sums;
  const auto produce = [&](const core::Sink& sink) {
    if (!options.output.empty() && !options.codes) sink(quads::kPlanarCodeHeader);
    sums = Parts(sink).found(options);
    if (!sums.complete) throw Stopped();
  };
  if (options.output.empty())
    produce([](std::string_view) {});
  else
    core::write_file_in_parts(options.output, produce);
  return sums;
}

std::string words_if_stopped(const std::string& output) {
  if (output.empty()) return "stopped; there is no total";
  std::error_code unknown;
  const auto status = std::filesystem::status(output, unknown);
  const bool is_replaced = output != "-" && (!std::filesystem::exists(status) ||
                                             std::filesystem::is_regular_file(status));
  return is_replaced ? "stopped; nothing is written" : "stopped; the list is not whole";
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
  try {
    const quads::Sums sums = list_to_output(options);
    tell(options.output, options.json ? json_line(options, sums) : report(options, sums));
    return ExitCode::yes;
  } catch (const Stopped&) {
    say(words_if_stopped(options.output));
    return ExitCode::undecided;
  }
}

}  // namespace hexatlas::cli
