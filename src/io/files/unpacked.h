#pragma once

#include <filesystem>
#include <string>

namespace swathplan {

/// True for .zip, .tar, .tgz, .tar.gz and .gz files, by their name and first bytes.
[[nodiscard]] bool is_packed(const std::filesystem::path& path);

/// A packed file, laid out in a folder of its own that goes with this object.
class Unpacked {
 public:
  /// `layer` names the file to read where several are packed together (names separated by commas,
  /// with or without folder and extension). Files that only go with others (.prj, .tfw, ...) do not
  /// count; nor do the updates of a chart's cell (.001, ...), which are laid beside it.
  /// @throws InvalidInput if the file cannot be unpacked to its end, holds nothing, is too large,
  /// or
  ///   holds several files none of which is chosen.
  Unpacked(const std::filesystem::path& packed, const std::string& layer);
  ~Unpacked();
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;
  Unpacked(Unpacked&&) = delete;
  Unpacked& operator=(Unpacked&&) = delete;

  /// The file to read.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// `text` with places in the folder shown as places in the packed file.
  [[nodiscard]] std::string in_words(std::string text) const;

 private:
  std::filesystem::path packed_, folder_, file_;
};

}  // namespace swathplan
