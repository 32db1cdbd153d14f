#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <memory>

#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/report/pictures_internal.h"
#include "mesh/base/error.h"

namespace swathplan::internal {
namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Dataset in_memory(const IndexedPicture& picture) {
  register_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  const int columns = static_cast<int>(picture.columns), rows = static_cast<int>(picture.rows);
  Dataset dataset(driver->Create("", columns, rows, 1, GDT_Byte, nullptr));
  GDALColorTable table(GPI_RGB);
  for (std::size_t i = 0; i < picture.palette.size(); ++i) {
    const Rgba& c = picture.palette[i];
    const GDALColorEntry entry{c.r, c.g, c.b, c.a};
    table.SetColorEntry(static_cast<int>(i), &entry);
  }
  dataset->GetRasterBand(1)->SetColorTable(&table);
  std::vector<std::uint8_t> pixels = picture.pixels;  // RasterIO takes no const
  const CPLErr error = dataset->GetRasterBand(1)->RasterIO(
      GF_Write, 0, 0, columns, rows, pixels.data(), columns, rows, GDT_Byte, 0, 0);
  return error == CE_None ? std::move(dataset) : nullptr;
}

}  // namespace

std::string png_bytes(const IndexedPicture& picture) {
  const QuietGdal quiet;
  const Dataset source = in_memory(picture);
  // The name holds an address, so that two threads never share one.
  const std::string name =
      fmt::format("/vsimem/swathplan-{}.png", static_cast<const void*>(&picture));
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("PNG");
  const char* const options[] = {"ZLEVEL=9", "WORLDFILE=NO", nullptr};
  if (!source || driver == nullptr ||
      !Dataset(driver->CreateCopy(name.c_str(), source.get(), FALSE, const_cast<char**>(options),
                                  nullptr, nullptr))) {
    throw InvalidInput("cannot make a picture for the report" + QuietGdal::why());
  }
  vsi_l_offset size = 0;
  GByte* data = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  VSIUnlink(name.c_str());
  VSIUnlink((name + ".aux.xml").c_str());
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      three = (three << 8) | (k < have ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= have ? kDigits[(three >> (18 - 6 * k)) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace swathplan::internal
