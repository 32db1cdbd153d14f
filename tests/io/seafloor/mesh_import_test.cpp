#include "io/seafloor/mesh_import.h"

#include <gmock/gmock.h>

#include "io/import_files.h"
#include "io/seafloor/surface_area.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using MeshImport = ImportFiles;

constexpr std::string_view kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nelement face 1\nproperty list uchar int vertex_indices\n";
constexpr std::string_view kPlyVertices =
    "585000.123 4797000.456 -1\n585010.123 4797000.456 -1\n585010 4797010 -1\n585000 4797010 -2\n";

std::string binary_stl(std::uint32_t says, std::uint32_t holds) {
  std::string bytes(80, 'x');
  bytes.append(reinterpret_cast<const char*>(&says), 4);
  const float facet[12] = {0, 0, 1, 0, 0, -1, 10, 0, -2, 0, 10, -3};
  for (std::uint32_t i = 0; i < holds; ++i) {
    bytes.append(reinterpret_cast<const char*>(facet), sizeof facet).append(2, '\0');
  }
  return bytes;
}

TEST_F(MeshImport, ObjKeepsEveryBitOfUtmCoordinates) {
  const SurfaceData data = read_mesh(write("a.obj",
                                           "# comment\no sea\nv 585000.123 4797000.456 -1.1\n"
                                           "vn 0 0 1\nvt 0 0\nv 585010.123 4797000.456 -1\n"
                                           "v 585010 4797010 -1\ns off\nl 1 2\nf 1/1/1 2//1 -1\n"));
  ASSERT_EQ(data.vertices.size(), 3U);
  EXPECT_EQ(data.vertices[0], Vec3(585000.123, 4797000.456, -1.1));
  EXPECT_EQ(data.vertices[1], Vec3(585010.123, 4797000.456, -1));
  ASSERT_EQ(data.faces.size(), 1U);
  EXPECT_EQ(data.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST_F(MeshImport, PlyOffAndAsciiStlKeepDoubles) {
  const SurfaceData ply = read_mesh(write(
      "a.ply", std::string(kPlyHead) + "end_header\n" + std::string(kPlyVertices) + "4 0 1 2 3\n"));
  EXPECT_EQ(ply.vertices[0], Vec3(585000.123, 4797000.456, -1));
  EXPECT_EQ(ply.faces.size(), 2U);
  const SurfaceData off =
      read_mesh(write("a.off", "OFF\n4 1 0\n" + std::string(kPlyVertices) + "4 0 1 2 3\n"));
  EXPECT_EQ(off.vertices[1], Vec3(585010.123, 4797000.456, -1));
  EXPECT_EQ(off.faces.size(), 2U);
  const SurfaceData stl = read_mesh(
      write("a.stl",
            "solid s\nfacet normal 0 0 1\nouter loop\nvertex 585000.123 4797000.456 -1\n"
            "vertex 585010.123 4797000.456 -1\nvertex 585010 4797010 -1\nendloop\nendfacet\n"
            "endsolid s\n"));
  EXPECT_EQ(stl.format, "ASCII STL");
  EXPECT_EQ(stl.vertices[0], Vec3(585000.123, 4797000.456, -1));
}

TEST_F(MeshImport, BinaryStlIsReadEvenIfItSaysSolid) {
  std::string bytes = binary_stl(2, 2);
  EXPECT_EQ(read_mesh(write("a.stl", bytes)).faces.size(), 2U);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_mesh(write("b.stl", bytes)).format, "binary STL");
}

TEST_F(MeshImport, RefusesTruncatedAndGarbledFiles) {
  const auto says = [&](const std::string& name, std::string_view bytes) {
    return refusal([&] { return read_mesh(write(name, bytes)); });
  };
  const std::string vertices = "v 0 0 -1\nv 1 0 -1\nv 0 1 -1\n";
  EXPECT_THAT(says("a.obj", vertices), HasSubstr("no faces"));
  EXPECT_THAT(says("a.obj", vertices + "v 0 1"), HasSubstr("line 4"));
  EXPECT_THAT(says("a.obj", vertices + "f 1 2 9\n"), HasSubstr("vertex 9"));
  EXPECT_THAT(says("a.obj", vertices + "f 1 2 0\n"), HasSubstr("line 4"));
  EXPECT_THAT(says("a.obj", vertices + "f 1 2\n"), HasSubstr("fewer than three"));
  std::string many = vertices + "f";
  for (int i = 0; i < 3000; ++i) many += " " + std::to_string(i % 3 + 1);
  EXPECT_THAT(says("a.obj", many + "\n"), HasSubstr("face 1: has 3000 corners"));
  EXPECT_THAT(says("a.obj", "v 0 0 nan\n"), HasSubstr("not finite"));
  EXPECT_THAT(says("a.obj", "v 0,5 0 -1\n"), HasSubstr("line 1"));
  EXPECT_THAT(says("a.ply", kPlyHead), HasSubstr("end_header"));
  const std::string ply = std::string(kPlyHead) + "end_header\n" + std::string(kPlyVertices);
  EXPECT_THAT(says("a.ply", ply), HasSubstr("truncated"));
  EXPECT_THAT(says("a.ply", ply + "4 0 1 2 9\n"), HasSubstr("vertex 10"));
  const auto head = [&](const std::string& from, const std::string& to) {
    std::string text = ply + "4 0 1 2 3\n";
    text.replace(text.find(from), from.size(), to);
    return says("a.ply", text);
  };
  EXPECT_THAT(head("element face", "element0face"), HasSubstr("line 7, 'element0face 1'"));
  EXPECT_THAT(head("format ascii 1.0", "format ascii"), HasSubstr("line 2, 'format ascii'"));
  EXPECT_THAT(head("double x", "list uchar double x"), HasSubstr("'x' of a type other than"));
  EXPECT_THAT(head("double x", "int x"), HasSubstr("'x' of a type other than"));
  EXPECT_THAT(head("double x", "double w"), HasSubstr("one x, one y and one z"));
  EXPECT_THAT(head("uchar int vertex", "uchar float vertex"), HasSubstr("no list of whole"));
  EXPECT_THAT(head("list uchar int vertex_indices", "int vertex_indices"), HasSubstr("no list"));
  EXPECT_THAT(says("a.stl", binary_stl(3, 2)), HasSubstr("truncated"));
  EXPECT_THAT(says("a.stl", "solid s\nfacet normal 0 0 1\n"), HasSubstr("endsolid"));
  EXPECT_THAT(says("a.stl", "solid s\nendsolid s\n"), HasSubstr("neither"));
  for (const char* name : {"g.obj", "g.ply", "g.off", "g.stl", "g.glb", "g.gltf", "g.dae"}) {
    EXPECT_THAT(says(name, garbage(3000)), HasSubstr(name));
  }
}

TEST_F(MeshImport, RealMeshesAgreeWhateverTheirFormat) {
  const std::string folder = "munkholmen_seabed_mesh/";
  if (!std::filesystem::exists(shared_dataset(folder))) GTEST_SKIP() << "no shared datasets";
  const SurfaceData obj = read_mesh(shared_dataset(folder + "munkholmen_seabed.obj"));
  const SurfaceData stl = read_mesh(shared_dataset(folder + "munkholmen_seabed.stl"));
  const SurfaceData dae = read_mesh(shared_dataset(folder + "seabed.dae"));
  EXPECT_EQ(obj.vertices.size(), 1088U);
  for (const SurfaceData* data : {&obj, &stl, &dae}) {
    EXPECT_EQ(data->faces.size(), 2115U);
    EXPECT_NEAR(test::plan_area(*data), test::plan_area(obj), 10.0);
    double low = 0.0;
    for (const Vec3& v : data->vertices) low = std::min(low, v.z());
    EXPECT_NEAR(low, -64.352, 1e-3);
  }
}

}  // namespace
}  // namespace swathplan
