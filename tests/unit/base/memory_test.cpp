#include "creepcontact/base/memory.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace creepcontact {
namespace {

enum class Kind { first, second };

struct Point {
  Kind kind = Kind::first;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::array<double, 3> normal{};
  bool closed = false;
  bool operator==(const Point&) const = default;
  static constexpr auto members = std::tuple{Member{"kind", &Point::kind}, Member{"place", &Point::place},
                                             Member{"normal", &Point::normal}, Member{"closed", &Point::closed}};
};

struct Path {
  std::int64_t steps = 0;
  std::vector<double> times;
  Eigen::VectorXd rows;
  std::vector<Point> points;
  Point last;
  bool operator==(const Path&) const = default;
  static constexpr auto members =
      std::tuple{Member{"steps", &Path::steps}, Member{"times", &Path::times}, Member{"rows", &Path::rows},
                 Member{"points", &Path::points}, Member{"last", &Path::last}};
};

struct Everything {
  std::vector<Path> paths;
  std::vector<std::vector<double>> parts;
  std::optional<double> largest;
  std::optional<double> none = 1.0;
  std::optional<Point> there;
  std::optional<Path> way;
  std::string method;
  bool operator==(const Everything&) const = default;
  static constexpr auto members =
      std::tuple{Member{"paths", &Everything::paths},     Member{"parts", &Everything::parts},
                 Member{"largest", &Everything::largest}, Member{"none", &Everything::none},
                 Member{"there", &Everything::there},     Member{"way", &Everything::way},
                 Member{"method", &Everything::method}};
};

Point point(double x) {
  return {.kind = Kind::second, .place = {x, -x}, .normal = {0, 1, x}, .closed = true};
}

Path path() {
  return {.steps = std::int64_t{1} << 53,
          .times = {0, 1.0 / 3},
          .rows = Eigen::Vector3d{1, 2, std::numeric_limits<double>::denorm_min()},
          .points = {point(1), point(2)},
          .last = point(3)};
}

Everything everything() {
  return {.paths = {path(), {}},
          .parts = {{1, 2}, {}},
          .largest = 0.1,
          .none = {},
          .there = point(4),
          .way = path(),
          .method = "cvode_bdf"};
}

TEST(Memory, RestoresWhatItSaved) {
  Memory memory;
  memory.save("run", everything());
  Everything found{.paths = {{}, {}, path()}, .parts = {{1}}, .largest = {}, .there = {}, .way = {}, .method = "euler"};
  memory.restore("run", found);
  EXPECT_TRUE(found == everything());
}

TEST(Memory, NamesFollowFromTheMembers) {
  Memory memory;
  memory.save("path", path());
  memory.save("", Point{});
  memory.save("parts", std::vector<std::vector<double>>{{1, 2}, {}});
  const Memory expected{{"path.steps", {std::pow(2, 53)}},
                        {"path.times", {0, 1.0 / 3}},
                        {"path.rows", {1, 2, std::numeric_limits<double>::denorm_min()}},
                        {"path.points.kind", {1, 1}},
                        {"path.points.place", {1, -1, 2, -2}},
                        {"path.points.normal", {0, 1, 1, 0, 1, 2}},
                        {"path.points.closed", {1, 1}},
                        {"path.last.kind", {1}},
                        {"path.last.place", {3, -3}},
                        {"path.last.normal", {0, 1, 3}},
                        {"path.last.closed", {1}},
                        {"kind", {0}},
                        {"place", {0, 0}},
                        {"normal", {0, 0, 0}},
                        {"closed", {0}},
                        {"parts", {2}},
                        {"parts.0", {1, 2}},
                        {"parts.1", {}}};
  EXPECT_EQ(memory, expected);
}

class Counter {
 public:
  explicit Counter(int steps) : steps_(steps) {}
  int steps() const { return steps_; }
  void save(Memory& memory) const { memory.save("counter", *this, saved_members); }
  void restore(const Memory& memory) { memory.restore("counter", *this, saved_members); }

 private:
  int steps_;
  static constexpr auto saved_members = std::tuple{Member{"steps", &Counter::steps_}};
};

TEST(Memory, TakesSomeMembersOfAClass) {
  Memory memory;
  Counter(7).save(memory);
  EXPECT_EQ(memory, (Memory{{"counter.steps", {7}}}));
  Counter found(1);
  found.restore(memory);
  EXPECT_EQ(found.steps(), 7);
}

TEST(Memory, ReplacesWhatHasTheSameName) {
  Memory memory;
  memory.save("points", std::vector{point(1), point(2)});
  memory.save("points", std::vector<Point>{});
  std::vector<Point> found{point(3)};
  memory.restore("points", found);
  EXPECT_TRUE(found.empty());
}

TEST(Memory, MissingAndUnfitArraysAreNamed) {
  const auto message = [](const Memory& memory) -> std::string {
    Path found;
    try {
      memory.restore("path", found);
    } catch (const std::out_of_range& error) {
      return error.what();
    }
    return "";
  };
  Memory memory;
  memory.save("path", path());
  EXPECT_EQ(message(memory), "");
  for (const auto& [name, numbers] : memory) {
    Memory cut = memory;
    cut.erase(name);
    EXPECT_NE(message(cut).find('\'' + name + '\''), std::string::npos) << name << ": " << message(cut);
  }
  memory["path.points.normal"].pop_back();
  EXPECT_NE(message(memory).find("'path.points.normal'"), std::string::npos) << message(memory);
}

}  // namespace
}  // namespace creepcontact
