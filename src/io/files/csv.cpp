#include "io/files/csv.h"

#include <algorithm>

#include "io/files/text.h"

namespace swathplan {
namespace {

/// The separator that the first line holds most of.
char separator_of(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n'));
  char best = ',';
  for (const char c : {',', ';', '\t'}) {
    if (std::count(first.begin(), first.end(), c) > std::count(first.begin(), first.end(), best)) {
      best = c;
    }
  }
  return best;
}

/// Cuts text into records, one call each.
class Records {
 public:
  explicit Records(std::string_view text) : text_(text), separator_(separator_of(text)) {}

  [[nodiscard]] bool done() const { return at_ >= text_.size(); }

  CsvTable::Row next() {
    CsvTable::Row row{.line = line_, .fields = {""}};
    bool quoted = false;
    while (!done()) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (quoted && c == '"' && at_ < text_.size() && text_[at_] == '"') {
        row.fields.back() += text_[at_++];
      } else if (c == '"') {
        quoted = !quoted;
      } else if (!quoted && c == separator_) {
        row.fields.emplace_back();
      } else if (!quoted && c == '\n') {
        break;
      } else {
        row.fields.back() += c;
      }
    }
    for (std::string& field : row.fields) field = std::string(trim(field));
    return row;
  }

 private:
  std::string_view text_;
  char separator_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

CsvTable parse_csv(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CsvTable table;
  Records records(text);
  while (!records.done()) {
    CsvTable::Row row = records.next();
    if (row.fields.size() == 1 && row.fields[0].empty()) continue;
    if (table.header.empty()) {
      for (const std::string& field : row.fields) table.header.push_back(lower(field));
    } else {
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace swathplan
