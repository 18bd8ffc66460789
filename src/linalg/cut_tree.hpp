#pragma once
/// The elimination tree of a factor, cut into tasks for several threads, with the memory that they work in.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/task_list.hpp"
#include "supernodal_pass.hpp"

namespace creepcontact::linalg {

/// A subtree or a supernode above the subtrees: it passes updates to the rows below its last column.
struct Branch {
  std::int64_t root = 0;               // supernode
  Index parent = -1;                   // branch
  std::vector<std::int32_t> in_front;  // where the rows below are among the rows of the parent
  Progress forward_done, backward_done;
};

struct CutTree {
  struct Subtree {
    std::size_t branch = 0;
    std::int64_t first = 0;             // supernode
    std::vector<std::int32_t> outside;  // of all its supernodes one after the other: rows below the root
    std::int64_t most_rows = 0;         // of its supernodes
    std::vector<double> update, work;   // n_below(root), most_rows; per vector of a pass
  };
  struct Front;
  struct Column {  // a panel of columns of a Front
    std::int64_t begin = 0, end = 0;
    std::vector<double> update;  // rows end .. n_rows, per vector of a pass
    Progress progress;
  };
  struct Front {
    std::size_t branch = 0;
    std::int64_t depth = 0;
    std::vector<std::size_t> children;  // branches
    std::vector<double> values;         // n_rows, per vector of a pass
    std::vector<Column> panels;
  };
  struct Task {
    Subtree* subtree;
    Front* front;
    std::size_t panel;
  };

  /// @throws std::logic_error if the supernodes are not in postorder
  explicit CutTree(const Supernodes& supernodes);

  Supernodes nodes;
  std::vector<std::unique_ptr<Branch>> branches;
  std::vector<Subtree> subtrees;
  std::vector<std::unique_ptr<Front>> fronts;
  std::vector<Index> front_of, subtree_of;  // of a branch, or -1
  std::vector<Task> tasks;                  // of a forward pass; a back substitution begins with the last
  std::vector<double> work;                 // of the tasks

 private:
  struct Tree;
  void cut(const Tree& tree);
  void place_children();
  void list_tasks(const Tree& tree);
};

}  // namespace creepcontact::linalg
