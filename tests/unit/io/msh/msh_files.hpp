#pragma once
// Two tetrahedra and a triangle as .msh files of every kind: tags with gaps, a node and an element outside all groups,
// a cell in two groups, and sections that are passed over.

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "creepcontact/io/msh/msh_writer.hpp"

namespace creepcontact::io::test {

inline const std::string ascii_22 = R"($Comments
$MeshFormat is yet to come
$EndComments
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "body"
3 2 "also here"
$EndPhysicalNames
$Nodes
6
9 1 1 1.5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
6 77 0 0
$EndNodes
$Elements
5
10 2 2 5 7 1 2 3
20 4 3 1 7 0 1 2 3 4
30 4 2 -1 7 2 3 4 9
31 4 4 2 7 1 -1 2 3 4 9
40 15 2 0 1 6
$EndElements
$Periodic
0
$EndPeriodic
$Nonsense
what ever
$EndNonsense
)";

inline const std::string ascii_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "body"
3 2 "also here"
$EndPhysicalNames
$Entities
1 0 1 2
3 77 0 0 0
7 0 0 0 1 1 0 1 5 0
1 0 0 0 0 0 0 1 -1 0
2 0 0 0 0 0 0 2 1 2 0
$EndEntities
$Nodes
4 6 1 9
0 3 0 1
6
77 0 0
2 7 1 3
1
2
3
0 0 0 0.5 0.5
1 0 0 0.5 0.5
0 1 0 0.5 0.5
3 1 0 1
4
0 0 1
3 2 0 1
9
1 1 1.5
$EndNodes
$Elements
4 4 10 40
2 7 2 1
10 1 2 3
3 1 4 1
20 1 2 3 4
3 2 4 1
30 2 3 4 9
0 3 15 1
40 6
$EndElements
$Periodic
0
$EndPeriodic
)";

inline std::string replaced(std::string text, const std::string& old, const std::string& next) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::logic_error("'" + old + "' is not in the file");
  return text.replace(at, old.size(), next);
}

/// Numbers in either order of bytes.
class Bytes {
 public:
  explicit Bytes(bool swapped) : swapped_(swapped) {}
  Bytes& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  template <typename T>
  Bytes& add(const std::vector<T>& values) {
    for (T value : values) {
      std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
      if (swapped_) std::reverse(bytes.begin(), bytes.end());
      bytes_ += bytes;
    }
    return *this;
  }
  Bytes& ints(const std::vector<std::int32_t>& values) { return add(values); }
  Bytes& sizes(const std::vector<std::uint64_t>& values) { return add(values); }
  Bytes& reals(const std::vector<double>& values) { return add(values); }
  std::string take() { return std::move(bytes_); }

 private:
  bool swapped_;
  std::string bytes_;
};

inline const std::string names = "$PhysicalNames\n2\n3 1 \"body\"\n3 2 \"also here\"\n$EndPhysicalNames\n";

inline std::string binary_22(bool swapped) {
  Bytes bytes(swapped);
  bytes.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n" + names + "$Nodes\n6\n");
  bytes.ints({9}).reals({1, 1, 1.5}).ints({1}).reals({0, 0, 0}).ints({2}).reals({1, 0, 0});
  bytes.ints({3}).reals({0, 1, 0}).ints({4}).reals({0, 0, 1}).ints({6}).reals({77, 0, 0});
  bytes.text("\n$EndNodes\n$Elements\n5\n").ints({2, 1, 2, 10, 5, 7, 1, 2, 3});
  bytes.ints({4, 2, 2, 20, 1, 7, 1, 2, 3, 4, 30, -1, 7, 2, 3, 4, 9}).ints({4, 1, 4, 31, 2, 7, 1, -1, 2, 3, 4, 9});
  return bytes.ints({15, 1, 2, 40, 0, 1, 6}).text("\n$EndElements\n").take();
}

inline std::string binary_41(bool swapped) {
  Bytes bytes(swapped);
  bytes.text("$MeshFormat\n4.1 1 8\n").ints({1}).text("\n$EndMeshFormat\n" + names + "$Entities\n").sizes({1, 0, 1, 2});
  bytes.ints({3}).reals({77, 0, 0}).sizes({0}).ints({7}).reals({0, 0, 0, 1, 1, 0}).sizes({1}).ints({5});
  bytes.sizes({2}).ints({4, -5}).ints({1}).reals({0, 0, 0, 0, 0, 0}).sizes({1}).ints({-1}).sizes({0});
  bytes.ints({2}).reals({0, 0, 0, 0, 0, 0}).sizes({2}).ints({1, 2}).sizes({0}).text("\n$EndEntities\n$Nodes\n");
  bytes.sizes({2, 6, 1, 9}).ints({0, 3, 0}).sizes({3, 6, 4, 9}).reals({77, 0, 0, 0, 0, 1, 1, 1, 1.5});
  bytes.ints({2, 7, 1}).sizes({3, 1, 2, 3}).reals({0, 0, 0, 5, 5, 1, 0, 0, 5, 5, 0, 1, 0, 5, 5});
  bytes.text("\n$EndNodes\n$Elements\n").sizes({4, 4, 10, 40}).ints({2, 7, 2}).sizes({1, 10, 1, 2, 3});
  bytes.ints({3, 1, 4}).sizes({1, 20, 1, 2, 3, 4}).ints({3, 2, 4}).sizes({1, 30, 2, 3, 4, 9});
  return bytes.ints({0, 3, 15}).sizes({1, 40, 6}).text("\n$EndElements\n").take();
}

}  // namespace creepcontact::io::test
