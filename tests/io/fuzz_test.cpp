#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "circumball/io.h"
#include "io_test_util.h"

// Allocations of this binary are counted: no file may take more memory than a small multiple of its
// size.
namespace {

std::size_t live_bytes = 0, peak_bytes = 0;
constexpr std::size_t kHeader = alignof(std::max_align_t);

void* counted_allocate(std::size_t size) {
  auto* block = static_cast<unsigned char*>(std::malloc(size + kHeader));
  if (!block) std::abort();
  *reinterpret_cast<std::size_t*>(block) = size;
  live_bytes += size;
  peak_bytes = std::max(peak_bytes, live_bytes);
  return block + kHeader;
}

void counted_free(void* pointer) {
  if (!pointer) return;
  auto* block = static_cast<unsigned char*>(pointer) - kHeader;
  live_bytes -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted_allocate(size); }
void* operator new[](std::size_t size) { return counted_allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted_allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return counted_allocate(size);
}
void operator delete(void* pointer) noexcept { counted_free(pointer); }
void operator delete[](void* pointer) noexcept { counted_free(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { counted_free(pointer); }
void operator delete[](void* pointer, std::size_t) noexcept { counted_free(pointer); }

namespace circumball {
namespace {

using io_test::files;
using io_test::folder;
using io_test::sample_complex;
using io_test::sample_complex_of_space_mesh;
using io_test::sample_mesh;
using io_test::sample_space_complex;
using io_test::sample_space_mesh;
using io_test::SplitMix64;

/// Bytes of memory that a byte of a file may cost, and bytes that any file may: JSON's "[]," makes
/// an array of its own out of three bytes; SVG's curves make as many chords as the file has bytes,
/// and 50,000 more.
constexpr std::size_t kMultiple = 250, kConstant = 10000000;

/// Valid files of every format, with the name and the siblings that they are read with.
struct Seed {
  std::string name, bytes;
};

std::vector<Seed> seeds() {
  std::string error;
  std::vector<Seed> out;
  for (const char* extension : {".poly", ".node", ".json", ".obj", ".svg"})
    out.push_back({std::string("a") + extension,
                   write_complex(sample_complex(), extension, &error).at(0).bytes});
  for (const char* extension : {".ele", ".json", ".off", ".obj"})
    out.push_back({std::string("m") + extension,
                   files(write_mesh(sample_mesh(), sample_complex(), extension, {}, &error), "m")
                       .at(std::string("m") + extension)});
  for (const char* extension : {".poly", ".json"})
    out.push_back({std::string("s") + extension,
                   write_complex(sample_space_complex(), extension, &error).at(0).bytes});
  for (const char* extension : {".ele", ".json", ".off", ".obj", ".ply", ".stl"})
    out.push_back({std::string("sm") + extension,
                   files(write_mesh(sample_space_mesh(), sample_complex_of_space_mesh(), extension,
                                    {}, &error),
                         "sm")
                       .at(std::string("sm") + extension)});
  out.push_back({"s.smesh", "0 3 0 0\n3 1\n3 1 2 3 7\n2 3\n4 1\n1 4 1\n1\n1 .5 .5 .5\n0\n"});
  for (const bool big : {false, true}) out.push_back({"b.ply", io_test::binary_ply(big)});
  out.push_back({"b.stl", io_test::binary_stl(4)});
  out.push_back({"a.poly", "0 2 0 0\n2 0\n1 1 2\n2 2 3\n1\n1 .5 .5\n"});
  out.push_back(
      {"a.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":
    {"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1e3],[0,0]]]}}]})"});
  out.push_back({"a.svg",
                 "<svg><g transform='rotate(30) scale(2)'><path d='M1 2h3v4C1 2 3 4 5 6S1 2 3 "
                 "4Q5 6 7 8T1 2A3 4 5 1 0 9 9z'/></g><rect x='1' width='5' height='6' rx='1'/>"
                 "<circle r='5'/><polygon points='1,2 3,4 5,6'/></svg>"});
  return out;
}

/// One file changed by a few random edits.
std::string mutate(std::string bytes, SplitMix64* random) {
  static const char* const kWords[] = {"999999999999", "-1",   "1e999",   "nan",       "4294967295",
                                       "[[[[",         "<g>",  "0 0 0 0", "\n",        "#",
                                       "\"",           "null", "{}",      "2147483647"};
  for (std::size_t edits = 1 + random->below(4); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = random->below(bytes.size());
    const std::size_t length = 1 + random->below(std::min<std::size_t>(bytes.size() - at, 40));
    switch (random->below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random->below(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random->below(256));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.erase(at, length);
        break;
      default:
        bytes.insert(at, kWords[random->below(std::size(kWords))]);
        break;
    }
  }
  return bytes;
}

/// Reads `bytes` and checks what must hold whatever they are.
void expect_tame(const std::string& name, const std::string& bytes, const Sibling& sibling,
                 std::size_t sibling_bytes) {
  peak_bytes = live_bytes;
  const std::size_t before = live_bytes;
  {
    const ReadResult r = read(bytes, name, sibling);
    ASSERT_LE(peak_bytes - before, kMultiple * (bytes.size() + sibling_bytes) + kConstant) << bytes;
    for (const Defect& d : r.defects) {
      ASSERT_FALSE(d.name.empty()) << bytes;
      ASSERT_FALSE(d.message.empty()) << bytes;
    }
    if (!r.ok()) {
      ASSERT_TRUE(r.complex.vertices.empty());
      return;
    }
    // A mesh is sound: the writers rely on it. Of a complex `check` tells what is not.
    const std::size_t n = r.complex.vertices.size();
    bool sound = true;
    for (const auto& s : r.complex.segments) sound = sound && s[0] < n && s[1] < n;
    const std::vector<Defect> numbers = check_numbers(r.complex);
    ASSERT_EQ(sound, std::none_of(numbers.begin(), numbers.end(),
                                  [](const Defect& d) {
                                    return d.name == "index-out-of-range" &&
                                           d.features[0].kind == FeatureKind::kSegment;
                                  }))
        << bytes;
    if (!numbers.empty()) {
      const std::vector<Defect> all = check(r.complex);
      ASSERT_GE(all.size(), numbers.size()) << bytes;
      smallest_angle_degrees(r.complex);
      with_box(r.complex, 3);
    }
    if (r.mesh) {
      for (const std::uint32_t v : r.mesh->cells) ASSERT_LT(v, r.mesh->vertices.size()) << bytes;
      for (const MeshFacet& f : r.mesh->facets)
        ASSERT_LT(std::max({f.a, f.b, f.c}), r.mesh->vertices.size()) << bytes;
      for (const MeshEdge& e : r.mesh->edges)
        ASSERT_TRUE(e.a < r.mesh->vertices.size() && e.b < r.mesh->vertices.size()) << bytes;
      ASSERT_TRUE(r.mesh->vertex_features.empty() ||
                  r.mesh->vertex_features.size() == r.mesh->vertices.size());
      ASSERT_TRUE(r.mesh->edge_markers.empty() ||
                  r.mesh->edge_markers.size() == r.mesh->edges.size());
      ASSERT_TRUE(r.mesh->cell_regions.empty() ||
                  r.mesh->cell_regions.size() == r.mesh->cell_count());
    }
    sound = sound && std::none_of(numbers.begin(), numbers.end(),
                                  [](const Defect& d) { return d.name == "index-out-of-range"; });
    std::string error;
    for (const std::string extension : {".poly", ".json", ".obj", ".svg", ".ply"}) {
      const std::size_t written = write_complex(r.complex, extension, &error).size();
      const bool space = r.complex.dimension == 3;
      if (extension == (space ? ".svg" : ".ply") || !sound) {
        ASSERT_EQ(written, 0u) << bytes;
      } else if (!space || extension == ".poly" || extension == ".json") {
        ASSERT_EQ(written, 1u) << bytes;
      }
      ASSERT_EQ(written == 0, !error.empty()) << bytes;
    }
    if (r.mesh) {
      for (const std::string& extension : mesh_extensions(r.mesh->dimension)) {
        ASSERT_FALSE(write_mesh(*r.mesh, r.complex, extension, {}, &error).empty())
            << extension << bytes;
      }
    }
  }
  ASSERT_EQ(live_bytes, before);
}

TEST(Fuzz, NoMutationOfAValidFileCrashesOrTakesMuchMemory) {
  SplitMix64 random(2009);
  std::string error;
  const auto family = files(write_mesh(sample_mesh(), sample_complex(), ".ele", {}, &error), "m");
  const auto family_of_space = files(
      write_mesh(sample_space_mesh(), sample_complex_of_space_mesh(), ".ele", {}, &error), "sm");
  std::size_t accepted = 0, rounds = 0;
  for (const Seed& seed : seeds()) {
    for (int round = 0; round < 2500; ++round, ++rounds) {
      auto siblings = family;
      siblings.insert(family_of_space.begin(), family_of_space.end());
      siblings["s.node"] = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
      siblings["a.node"] = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
      const std::string bytes = mutate(seed.bytes, &random);
      std::size_t sibling_bytes = 0;
      for (auto& [name, content] : siblings) {
        if (random.below(4) == 0) content = mutate(content, &random);
        sibling_bytes += content.size();
      }
      expect_tame(seed.name, bytes, folder(siblings), sibling_bytes);
      if (HasFatalFailure()) return;
      accepted += read(bytes, seed.name, folder(siblings)).ok();
    }
  }
  // Both outcomes occur often, so that neither goes untested.
  EXPECT_GT(accepted, rounds / 20);
  EXPECT_LT(accepted, rounds - rounds / 20);
}

TEST(Fuzz, RandomBytesAreRefused) {
  SplitMix64 random(5);
  for (int round = 0; round < 5000; ++round) {
    std::string bytes(random.below(200), '\0');
    const bool text = round % 2 == 0;
    static const std::string kAlphabet = "0123456789 .-+eE\n\t#,<>/\"'{}[]:vlfOMz";
    for (char& c : bytes)
      c = text ? kAlphabet[random.below(kAlphabet.size())] : static_cast<char>(random.below(256));
    expect_tame("a.poly", bytes, nullptr, 0);
    if (HasFatalFailure()) return;
  }
}

TEST(Fuzz, FilesThatTryToBeExpensiveAreNot) {
  const auto repeated = [](const std::string& head, const std::string& unit, std::size_t size) {
    std::string out = head;
    while (out.size() < size) out += unit;
    return out;
  };
  constexpr std::size_t kSize = 200000;
  const std::string own = R"({"circumball":1,"dimension":2,"vertices":[[0,0]],"x":[)";
  const std::string cases[] = {
      repeated(own, "[],", kSize) + "[]]}",
      repeated(own, "0,", kSize) + "0]}",
      repeated(own, "{\"a\":0},", kSize) + "0]}",
      repeated("<svg><path d='M0 0", "A1 1 0 0 0 1 1 0 0", kSize) + "'/></svg>",
      repeated("<svg><path d='M0 0c", "9 9 9-9 1 0 ", kSize) + "'/></svg>",
      repeated("<svg><path d='M0 0c", "9 9-9 9 .001 0 ", kSize) + "'/></svg>",
      repeated("<svg><path d='M0 0a", "9 9 0 1 0 .001 0 ", kSize) + "'/></svg>",
      repeated("<svg>", "<circle r='9'/>", kSize) + "</svg>",
      repeated("<svg>", "<g>", kSize),
      repeated("v 0 0\n", "l 1 1\n", kSize),
      repeated("v 0 0\n", "f 1 1 1\n", kSize),
      repeated("99999 2 0 0\n", "1 0 0\n", kSize),
      repeated("", "-", kSize),
      repeated("1 2 0 0\n1 0 0", "0", kSize),
      repeated("1 2 0 0\n1 0 1e", "9", kSize),
      repeated("1 3 0 0\n1 0 0 0\n49000 0\n", "1\n1 1\n", kSize),
      repeated("1 3 0 0\n1 0 0 0\n1 0\n40000\n", "1 1\n", kSize),
      repeated("4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 0\n1\n90000", " 1 2 3 4", kSize),
      repeated("4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n12000 0\n", "1\n3 1 2 3\n", kSize),
      repeated("v 0 0 1\nv 1 0 1\nv 0 1 1\n", "f 1 2 3\n", kSize),
      repeated("v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1", " 2 3", kSize),
      repeated("solid\n",
               "facet normal 0 0 1 outer loop vertex 0 0 1 vertex 1 0 0 vertex 0 1 0\n"
               "endloop endfacet\n",
               kSize) +
          "endsolid",
      repeated("solid\nouter loop\n", "vertex 0 0 1\nvertex 1 0 0\n", kSize) +
          "endloop endfacet\nendsolid",
      io_test::binary_stl(kSize / 50),
      repeated("ply\nformat ascii 1.0\n", "element a 0\n", kSize) + "end_header\n",
      repeated("ply\nformat ascii 1.0\nelement vertex 9\n", "property int x\n", kSize) +
          "property int y\nend_header\n",
      repeated("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\n"
               "element face 60000\nproperty list int int vertex_indices\nend_header\n0 0\n",
               "2 0 0\n", kSize),
  };
  for (const std::string& bytes : cases) {
    expect_tame("a", bytes, nullptr, 0);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace circumball
