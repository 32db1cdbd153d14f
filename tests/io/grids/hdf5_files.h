#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace swathplan {

/// Writes HDF5 files with groups, attributes and arrays of records: a netCDF-4 file is such.
class Hdf5Writer {
 public:
  using Group = std::shared_ptr<GDALGroup>;

  explicit Hdf5Writer(const std::filesystem::path& path) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
    const char* const options[] = {"FORMAT=NC4", nullptr};
    file_.reset(driver->CreateMultiDimensional(path.c_str(), nullptr, options));
    EXPECT_TRUE(file_);
  }

  [[nodiscard]] Group root() const { return file_->GetRootGroup(); }
  static Group group(const Group& in, const std::string& name) { return in->CreateGroup(name); }

  static void attribute(const Group& in, const std::string& name, const std::string& text) {
    const auto a = in->CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
    EXPECT_TRUE(a && a->Write(text.c_str()));
  }
  static void attribute(const Group& in, const std::string& name, double value) {
    const auto a = in->CreateAttribute(name, {}, GDALExtendedDataType::Create(GDT_Float64));
    EXPECT_TRUE(a && a->Write(value));
  }
  static void code(const Group& in, const std::string& name, int value) {
    const auto a = in->CreateAttribute(name, {}, GDALExtendedDataType::Create(GDT_Int32));
    EXPECT_TRUE(a && a->Write(value));
  }

  /// An array of characters.
  static void text(const Group& in, const std::string& name, const std::string& characters) {
    const char* const options[] = {"NC_TYPE=NC_CHAR", nullptr};
    const auto type = GDALExtendedDataType::CreateString(characters.size());
    const auto array = in->CreateMDArray(name, {}, type, options);
    ASSERT_TRUE(array);
    const char* value = characters.c_str();
    write(*array, {}, GDALExtendedDataType::CreateString(), static_cast<const void*>(&value));
  }

  /// An array of 32-bit numbers.
  static void floats(const Group& in, const std::string& name, const std::vector<std::size_t>& size,
                     const std::vector<float>& values) {
    const auto array = in->CreateMDArray(name, dimensions(in, name, size),
                                         GDALExtendedDataType::Create(GDT_Float32));
    write(*array, size, GDALExtendedDataType::Create(GDT_Float32), values.data());
  }

  /// An array of records of 32-bit numbers; the fields whose names are in `whole` are integers.
  static std::shared_ptr<GDALMDArray> records(const Group& in, const std::string& name,
                                              const std::vector<std::size_t>& size,
                                              const std::vector<std::string>& fields,
                                              std::size_t whole, const std::vector<float>& values) {
    std::vector<std::unique_ptr<GDALEDTComponent>> parts;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      parts.push_back(std::make_unique<GDALEDTComponent>(
          fields[i], 4 * i, GDALExtendedDataType::Create(i < whole ? GDT_UInt32 : GDT_Float32)));
    }
    const auto type =
        GDALExtendedDataType::Create(name + "_t", 4 * fields.size(), std::move(parts));
    std::vector<char> bytes(4 * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto integer = static_cast<std::uint32_t>(values[i]);
      std::memcpy(&bytes[4 * i],
                  i % fields.size() < whole ? static_cast<const void*>(&integer)
                                            : static_cast<const void*>(&values[i]),
                  4);
    }
    const auto array = in->CreateMDArray(name, dimensions(in, name, size), type);
    EXPECT_TRUE(array);
    write(*array, size, type, bytes.data());
    return array;
  }

 private:
  static std::vector<std::shared_ptr<GDALDimension>> dimensions(
      const Group& in, const std::string& name, const std::vector<std::size_t>& size) {
    std::vector<std::shared_ptr<GDALDimension>> all;
    for (std::size_t i = 0; i < size.size(); ++i) {
      all.push_back(in->CreateDimension(name + "_" + std::to_string(i), "", "", size[i]));
    }
    return all;
  }
  static void write(GDALMDArray& array, const std::vector<std::size_t>& size,
                    const GDALExtendedDataType& type, const void* values) {
    const std::vector<GUInt64> start(size.size(), 0);
    EXPECT_TRUE(array.Write(start.data(), size.data(), nullptr, nullptr, type, values));
  }

  std::unique_ptr<GDALDataset> file_;
};

}  // namespace swathplan
