#include "tables/build/census.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/format/sha256.hpp"

namespace hexatlas::build {
namespace {

constexpr int kApplication = 0x48584331;  // "HXC1"
constexpr int kVersion = 1;

/// As SQLite keeps them: a census has exactly these.
constexpr std::array<std::string_view, 2> kTables{
    "CREATE TABLE about (format INTEGER NOT NULL, table_format INTEGER NOT NULL, "
    "table_sha256 TEXT NOT NULL, program TEXT NOT NULL, \"commit\" TEXT NOT NULL, "
    "rows_sha256 TEXT NOT NULL) STRICT",
    "CREATE TABLE census (code TEXT NOT NULL PRIMARY KEY, quads INTEGER NOT NULL, "
    "automorphisms INTEGER NOT NULL, rotations INTEGER NOT NULL, hexahedra INTEGER NOT NULL, "
    "interior_vertices INTEGER NOT NULL, lower_bound INTEGER NOT NULL, source TEXT NOT NULL, "
    "found TEXT NOT NULL) STRICT, WITHOUT ROWID"};

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  void operator()(unsigned char* bytes) const { sqlite3_free(bytes); }
};
using Database = std::unique_ptr<sqlite3, Close>;

/// What SQLite reports as an error. Databases are in memory only, so it is either that memory, or
/// the content of the file that was read.
[[noreturn]] void refuse(int error, const std::string& path) {
  const std::string reason = sqlite3_errstr(error);
  if ((error & 0xFF) == SQLITE_NOMEM || (error & 0xFF) == SQLITE_FULL ||
      error == SQLITE_IOERR_NOMEM)
    throw core::ResourceFailure(path + ": SQLite: " + reason);
  throw core::InvalidInput(path, "is not a census, or damaged: SQLite says: " + reason);
}

Database in_memory(const std::string& path) {
  sqlite3* database = nullptr;
  const int error =
      sqlite3_open_v2(":memory:", &database,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_MEMORY, nullptr);
  Database result(database);
  if (error != SQLITE_OK) refuse(error, path);
  return result;
}

/// One statement, prepared. `path` stands for the database in messages.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql, const std::string& path) : path_(path) {
    sqlite3_stmt* statement = nullptr;
    const int error =
        sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    if (error != SQLITE_OK) refuse(error, path_);
  }

  void bind(int place, int value) { expect_done(sqlite3_bind_int(statement_.get(), place, value)); }
  /// The text must outlive the step.
  void bind(int place, const std::string& text) {
    expect_done(sqlite3_bind_text(statement_.get(), place, text.data(),
                                  static_cast<int>(text.size()), SQLITE_STATIC));
  }

  /// Whether there is a row; at the end the statement may be bound anew.
  bool step() {
    const int result = sqlite3_step(statement_.get());
    if (result == SQLITE_ROW) return true;
    if (result != SQLITE_DONE) refuse(result, path_);
    sqlite3_reset(statement_.get());
    return false;
  }

  [[nodiscard]] std::string text(int column) {
    const unsigned char* const bytes = sqlite3_column_text(statement_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    if (bytes == nullptr) expect_memory();
    return bytes == nullptr ? "" : std::string(bytes, bytes + size);
  }
  /// Numbers that a census does not hold are those of a damaged one.
  [[nodiscard]] int number(int column) {
    const sqlite3_int64 value = sqlite3_column_int64(statement_.get(), column);
    if (!std::in_range<int>(value))
      throw core::InvalidInput(path_, "is damaged: a number is too large");
    return static_cast<int>(value);
  }

  /// Some functions do not return that memory is short.
  void expect_memory() const {
    const int error = sqlite3_extended_errcode(sqlite3_db_handle(statement_.get()));
    if ((error & 0xFF) == SQLITE_NOMEM || error == SQLITE_IOERR_NOMEM) refuse(error, path_);
  }

 private:
  void expect_done(int result) const {
    if (result != SQLITE_OK) refuse(result, path_);
  }

  std::unique_ptr<sqlite3_stmt, Close> statement_;
  const std::string& path_;
};

void run(sqlite3* database, const std::string& sql, const std::string& path) {
  Statement statement(database, sql, path);
  while (statement.step()) {
  }
}

/// Of all that a census says, as text: sizes before the words keep two of them apart.
std::string digest_of(const Census& census) {
  std::string text;
  const auto add = [&](const std::string& word) {
    text += std::to_string(word.size()) + " " + word + "\n";
  };
  for (const std::string* word :
       {&census.about.table_sha256, &census.about.program, &census.about.commit})
    add(*word);
  for (const CensusRow& row : census.rows) {
    for (const int number : {row.quads, row.automorphisms, row.rotations, row.hexahedra,
                             row.interior_vertices, row.lower_bound})
      text += std::to_string(number) + "\n";
    for (const std::string* word : {&row.code, &row.source, &row.found}) add(*word);
  }
  const std::array<std::string_view, 1> whole{text};
  return format::to_hex(format::sha256(whole));
}

void fill(sqlite3* database, const Census& census, const std::string& path) {
  for (const std::string_view table : kTables) run(database, std::string(table), path);
  Statement about(database, "INSERT INTO about VALUES (?, ?, ?, ?, ?, ?)", path);
  const std::string digest = digest_of(census);
  about.bind(1, kVersion);
  about.bind(2, static_cast<int>(format::kTableVersion));
  about.bind(3, census.about.table_sha256);
  about.bind(4, census.about.program);
  about.bind(5, census.about.commit);
  about.bind(6, digest);
  (void)about.step();
  Statement insert(database, "INSERT INTO census VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", path);
  for (const CensusRow& row : census.rows) {
    insert.bind(1, row.code);
    insert.bind(2, row.quads);
    insert.bind(3, row.automorphisms);
    insert.bind(4, row.rotations);
    insert.bind(5, row.hexahedra);
    insert.bind(6, row.interior_vertices);
    insert.bind(7, row.lower_bound);
    insert.bind(8, row.source);
    insert.bind(9, row.found);
    (void)insert.step();
  }
}

void expect_census(sqlite3* database, const std::string& path) {
  const auto number = [&](const char* pragma) {
    Statement statement(database, pragma, path);
    return statement.step() ? statement.number(0) : 0;
  };
  if (number("PRAGMA application_id") != kApplication)
    throw core::InvalidInput(path, "is not a census: it is another database");
  const int version = number("PRAGMA user_version");
  if (version != kVersion)
    throw core::InvalidInput(path, "is a census of version " + std::to_string(version) +
                                       "; this program reads version " + std::to_string(kVersion));
  Statement schema(database, "SELECT sql FROM sqlite_schema ORDER BY name", path);
  std::vector<std::string> tables;
  while (schema.step()) tables.push_back(schema.text(0));
  if (!std::equal(tables.begin(), tables.end(), kTables.begin(), kTables.end()))
    throw core::InvalidInput(path, "is not a census: it has other tables");
  Statement integrity(database, "PRAGMA integrity_check(1)", path);
  const std::string told = integrity.step() ? integrity.text(0) : "";
  if (told == "ok") return;
  integrity.expect_memory();
  // It may be told as any other finding, with no error: by its words or by its number.
  for (const char* const shortage : {"out of memory", "error code=7", "error code=3082"})
    if (told.find(shortage) != std::string::npos) refuse(SQLITE_NOMEM, path);
  throw core::InvalidInput(path, "is damaged: SQLite says: " + told.substr(told.rfind('\n') + 1));
}

}  // namespace

CensusRow census_row(const format::TableEntry& entry, std::string source, std::string found) {
  const auto boundary = canon::decode(entry.code);
  core::expects(boundary.has_value(), "the code of an entry can be decoded");
  const canon::CanonicalForm form = canon::canonical_form(*boundary);
  return {canon::to_text(entry.code),
          entry.code.quads,
          form.automorphisms,
          form.rotations,
          entry.hexahedra,
          entry.interior_vertices,
          entry.lower_bound,
          std::move(source),
          std::move(found)};
}

std::string census_path(const std::string& table_path) {
  return std::filesystem::path(table_path).replace_extension(".census.sqlite").string();
}

std::string census_bytes(const std::string& path, Census census) {
  auto& rows = census.rows;
  std::sort(rows.begin(), rows.end(),
            [](const CensusRow& a, const CensusRow& b) { return a.code < b.code; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    core::expects(i == 0 || rows[i - 1].code != rows[i].code, "the codes of a census are distinct");
    core::expects(rows[i].lower_bound >= 1 && rows[i].hexahedra >= rows[i].lower_bound,
                  "no mesh has fewer hexahedra than its lower bound");
  }
  const Database database = in_memory(path);
  run(database.get(), "PRAGMA application_id = " + std::to_string(kApplication), path);
  run(database.get(), "PRAGMA user_version = " + std::to_string(kVersion), path);
  run(database.get(), "BEGIN", path);
  fill(database.get(), census, path);
  run(database.get(), "COMMIT", path);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, Close> bytes(
      sqlite3_serialize(database.get(), "main", &size, 0));
  if (!bytes) refuse(SQLITE_NOMEM, path);
  return {bytes.get(), bytes.get() + size};
}

Census read_census(const std::string& path) {
  std::string bytes = core::read_file(path);
  if (!bytes.starts_with("SQLite format 3"))
    throw core::InvalidInput(path, "is not a census: it is no SQLite database");
  const Database database = in_memory(path);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  const int error =
      sqlite3_deserialize(database.get(), "main", reinterpret_cast<unsigned char*>(bytes.data()),
                          size, size, SQLITE_DESERIALIZE_READONLY);
  if (error != SQLITE_OK) refuse(error, path);
  expect_census(database.get(), path);
  Census census;
  Statement about(
      database.get(),
      "SELECT table_format, table_sha256, program, \"commit\", rows_sha256, format FROM about",
      path);
  const bool is_there = about.step();
  if (!is_there || about.number(0) != static_cast<int>(format::kTableVersion) ||
      about.number(5) != kVersion)
    throw core::InvalidInput(path, "is damaged, or the census of a table of another version");
  census.about = {about.text(1), about.text(2), about.text(3)};
  const std::string digest = about.text(4);
  if (about.step())
    throw core::InvalidInput(path, "is damaged: it says twice of what it is the census");
  Statement select(database.get(), "SELECT * FROM census ORDER BY code", path);
  while (select.step())
    census.rows.push_back({select.text(0), select.number(1), select.number(2), select.number(3),
                           select.number(4), select.number(5), select.number(6), select.text(7),
                           select.text(8)});
  if (digest != digest_of(census))
    throw core::InvalidInput(path, "is damaged: its content is not that of its digest");
  return census;
}

}  // namespace hexatlas::build
