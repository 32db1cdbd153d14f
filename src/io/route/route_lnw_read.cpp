#include <fmt/format.h>

#include <map>

#include "io/files/text.h"
#include "io/route/route_planar.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Reads the records of an LNW file one after the other.
class LnwReader {
 public:
  explicit LnwReader(std::string file) : file_(std::move(file)) {}

  void read(std::size_t number, std::string_view text) {
    const auto words = split(text, ' ');
    if (words.empty()) return;
    number_ = number;
    const std::string record = lower(words[0]);
    if (record == "lin") {
      end_line();
      open_ = true;
      route_.parts.emplace_back();
      promised_ = words.size() > 1 ? whole_number(words[1]) : std::nullopt;
    } else if (record == "pts") {
      add_point(words);
    } else if (record == "lnn") {
      const auto name =
          words.size() > 1 ? whole_number(words[1].substr(0, words[1].find('_'))) : std::nullopt;
      if (!route_.parts.empty()) {
        for (ForeignPoint& p : route_.parts.back()) p.line = name;
      }
    } else if (record == "eol") {
      end_line();
    } else if (record == "lns") {
      lines_ = words.size() > 1 ? whole_number(words[1]) : std::nullopt;
    } else {
      ++others_[std::string(words[0].substr(0, 8))];
    }
  }

  [[nodiscard]] ForeignRoute done() && {
    end_line();
    if (lines_ && *lines_ != static_cast<int>(route_.parts.size())) {
      fail(fmt::format("holds {} lines where LNS says {}; is the file truncated?",
                       route_.parts.size(), *lines_));
    }
    others_.erase("LNW");
    for (const auto& [record, count] : others_) {
      route_.notes.push_back(fmt::format("{} record{} '{}' {} left out", count,
                                         count == 1 ? "" : "s", quotable(record),
                                         count == 1 ? "was" : "were"));
    }
    route_.notes.emplace_back(
        "planned lines name no coordinate reference system: that of the seafloor's file was taken");
    return std::move(route_);
  }

 private:
  void add_point(const std::vector<std::string_view>& words) {
    if (!open_) fail("PTS outside a line: LIN must stand before it");
    const auto x = words.size() < 3 ? std::nullopt : to_finite_number(words[1]);
    const auto y = words.size() < 3 ? std::nullopt : to_finite_number(words[2]);
    if (!x || !y) fail("PTS must be followed by easting and northing");
    route_.parts.back().push_back(
        {.place = Vec2(*x, *y), .line = std::nullopt, .speed_mps = std::nullopt});
  }

  void end_line() {
    if (open_ && promised_ && *promised_ != static_cast<int>(route_.parts.back().size())) {
      fail(fmt::format("the line before holds {} points where LIN says {}; is the file truncated?",
                       route_.parts.back().size(), *promised_));
    }
    open_ = false;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidInput(fmt::format("'{}', line {}: {}", file_, number_, what));
  }

  std::string file_;
  ForeignRoute route_{.in_degrees = false, .parts = {}, .notes = {}};
  std::map<std::string, int> others_;
  std::optional<int> promised_, lines_;
  std::size_t number_ = 0;
  bool open_ = false;
};

}  // namespace

ForeignRoute parse_route_lnw(std::string_view text, const std::string& file) {
  LnwReader reader(file);
  const auto lines = split(text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) reader.read(i + 1, lines[i]);
  return std::move(reader).done();
}

}  // namespace swathplan
