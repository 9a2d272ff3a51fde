#include "robot/urdf/urdf_chain.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <set>

namespace voluta::robot {

namespace {

using base::message;

bool turns(const UrdfJoint& joint) {
  return joint.type == "revolute" || joint.type == "continuous";
}

class Tree {
public:
  Tree(const UrdfTree& tree, std::string where) : tree_(tree), where_(std::move(where)) {
    for (std::size_t i = 0; i < tree.links.size(); ++i)
      if (!byName_.emplace(tree.links[i].name, i).second)
        fail(message("two links are named '{link}'"_text, tree.links[i].name));
    std::set<std::string_view> names;
    for (const UrdfJoint& joint : tree.joints)
      if (!names.insert(joint.name).second)
        fail(message("two joints are named '{joint}'"_text, joint.name));
    over_.resize(tree.links.size());
    under_.resize(tree.links.size());
    for (std::size_t j = 0; j < tree.joints.size(); ++j)
      hang(j);
    findRoot();
  }

  UrdfChain chain(const std::string& tip, const std::string& base) const {
    UrdfChain found;
    const std::size_t end = tip.empty() ? onlyTip() : named(tip, "--tip");
    found.tip = link(end).name;
    const std::vector<std::size_t> path = pathTo(end); // Joints from the root
    const std::size_t stand = base.empty() ? usualBase() : named(base, "--base");
    found.base = link(stand).name;

    // The base is a link of the chain, or fixed to one.
    std::size_t on = stand;
    Eigen::Isometry3d on_T_base = Eigen::Isometry3d::Identity();
    const auto isOnPath = [&](std::size_t l) {
      return l == root_ ||
             std::any_of(path.begin(), path.end(), [&](std::size_t j) { return childOf(j) == l; });
    };
    while (!isOnPath(on)) {
      const UrdfJoint& joint = tree_.joints[*over_[on]];
      if (joint.type != "fixed")
        fail(message("the base '{base}' is on a moving branch off the chain to '{tip}'"_text,
                     found.base, found.tip));
      on_T_base = joint.parent_T_joint * on_T_base;
      on = byName_.at(joint.parent);
    }
    std::size_t first = 0;
    while (on != root_ && childOf(path[first++]) != on) {
    }

    int frame = 0;
    Eigen::Isometry3d frame_T_link = on_T_base.inverse();
    std::vector<FixedLink> stems{{on, 0, frame_T_link}};
    for (std::size_t k = first; k < path.size(); ++k) {
      const UrdfJoint& joint = tree_.joints[path[k]];
      const Eigen::Isometry3d frame_T_joint = frame_T_link * joint.parent_T_joint;
      if (joint.type == "fixed") {
        frame_T_link = frame_T_joint;
      } else {
        requireTurning(joint);
        found.chain.joints.push_back({frame_T_joint, joint.axis.normalized()});
        found.joints.push_back(path[k]);
        frame_T_link.setIdentity();
        ++frame;
      }
      stems.push_back({childOf(path[k]), frame, frame_T_link});
    }
    found.chain.last_T_flange = frame_T_link;
    if (found.joints.size() != 6)
      fail(message("the chain from '{base}' to '{tip}' has {count} turning axes; six are "
                   "needed"_text,
                   found.base, found.tip, found.joints.size()),
           "name the first and last link of the chain: --base, --tip"_text);
    for (const FixedLink& stem : stems) {
      found.links.push_back(stem);
      addBranches(stem, path, found);
    }
    return found;
  }

  std::vector<std::string> tips() const {
    std::vector<std::string> names;
    for (const std::size_t l : allTips())
      names.push_back(link(l).name);
    return names;
  }

private:
  const UrdfLink& link(std::size_t l) const { return tree_.links[l]; }
  std::size_t childOf(std::size_t joint) const { return byName_.at(tree_.joints[joint].child); }
  [[noreturn]] void fail(const base::Message& what, const base::Message& remedy = {}) const {
    throw base::Error(base::ErrorCode::UnusableInput, what, where_, remedy);
  }

  void hang(std::size_t j) {
    const UrdfJoint& joint = tree_.joints[j];
    for (const std::string& name : {joint.parent, joint.child})
      if (!byName_.contains(name))
        fail(message("joint '{joint}' names an unknown link: '{link}'"_text, joint.name, name));
    auto& over = over_[byName_.at(joint.child)];
    if (over)
      fail(message("link '{link}' has two parent joints, '{first}' and '{second}': loops"
                   " are not supported"_text,
                   joint.child, tree_.joints[*over].name, joint.name));
    over = j;
    under_[byName_.at(joint.parent)].push_back(j);
  }

  void findRoot() {
    std::vector<std::string> roots;
    for (std::size_t l = 0; l < over_.size(); ++l)
      if (!over_[l]) {
        if (roots.empty())
          root_ = l;
        roots.push_back(link(l).name);
      }
    if (tree_.links.empty())
      fail("has no links"_text);
    if (roots.size() > 1)
      fail(message("has two bases, '{first}' and '{second}': no joint leads from one to the "
                   "other"_text,
                   roots[0], roots[1]));
    std::vector<std::size_t> reached;
    if (!roots.empty())
      reached.push_back(root_);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const std::size_t j : under_[reached[i]])
        reached.push_back(childOf(j));
    for (std::size_t l = 0; l < over_.size(); ++l)
      if (std::find(reached.begin(), reached.end(), l) == reached.end())
        fail(
            message("link '{link}' is part of a loop: loops are not supported"_text, link(l).name));
  }

  std::size_t named(const std::string& name, const char* option) const {
    const auto found = byName_.find(name);
    if (found != byName_.end())
      return found->second;
    std::vector<std::string> names;
    for (const UrdfLink& one : tree_.links)
      names.push_back(one.name);
    fail(message("{option}: no link is named '{name}'"_text, std::string(option), name),
         base::didYouMean(name, names));
  }

  std::vector<std::size_t> pathTo(std::size_t l) const {
    std::vector<std::size_t> path;
    for (; over_[l]; l = byName_.at(tree_.joints[path.back()].parent))
      path.push_back(*over_[l]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  // The last joint on the path from the root that moves the link.
  std::optional<std::size_t> mover(std::size_t l) const {
    for (; over_[l]; l = byName_.at(tree_.joints[*over_[l]].parent))
      if (tree_.joints[*over_[l]].type != "fixed")
        return over_[l];
    return std::nullopt;
  }

  std::vector<std::size_t> allTips() const {
    std::vector<std::size_t> tips;
    for (std::size_t l = 0; l < under_.size(); ++l)
      if (under_[l].empty() && mover(l))
        tips.push_back(l);
    return tips;
  }

  std::size_t onlyTip() const {
    const std::vector<std::size_t> tips = allTips();
    if (tips.empty())
      fail("has no tip: no joint moves"_text);
    if (tips.size() == 1)
      return tips.front();
    const bool together = std::all_of(
        tips.begin(), tips.end(), [&](std::size_t l) { return mover(l) == mover(tips.front()); });
    for (const std::size_t l : tips)
      if (together && link(l).name == "tool0")
        return l;
    fail(
        message("has several tips: {names}"_text, fmt::format("{}", fmt::join(this->tips(), ", "))),
        "name one: --tip"_text);
  }

  std::size_t usualBase() const {
    const auto found = byName_.find("base");
    return found != byName_.end() && !mover(found->second) ? found->second : root_;
  }

  void requireTurning(const UrdfJoint& joint) const {
    if (!joint.follows.empty())
      fail(message("joint '{joint}' mimics '{other}': mimic joints are not supported"_text,
                   joint.name, joint.follows));
    if (joint.type == "prismatic" || joint.type == "floating" || joint.type == "planar")
      fail(message("joint '{joint}' is {type}; only turning joints are supported"_text, joint.name,
                   joint.type));
    if (!turns(joint))
      fail(message("joint '{joint}' has an unknown type: '{type}'"_text, joint.name, joint.type));
    if (!(joint.axis.norm() > 0.0))
      fail(message("joint '{joint}' has an axis of zero length"_text, joint.name));
  }

  // Adds the links that are fixed beside the chain.
  void addBranches(const FixedLink& stem, const std::vector<std::size_t>& path,
                   UrdfChain& found) const {
    for (const std::size_t j : under_[stem.link]) {
      if (std::find(path.begin(), path.end(), j) != path.end())
        continue;
      const UrdfJoint& joint = tree_.joints[j];
      if (joint.type != "fixed") {
        found.leftOut.push_back(joint.name);
        continue;
      }
      const FixedLink branch{childOf(j), stem.frame, stem.frame_T_link * joint.parent_T_joint};
      found.links.push_back(branch);
      addBranches(branch, path, found);
    }
  }

  const UrdfTree& tree_;
  std::string where_;
  std::map<std::string, std::size_t> byName_;
  std::vector<std::optional<std::size_t>> over_; // Parent joint of each link
  std::vector<std::vector<std::size_t>> under_;  // Child joints of each link
  std::size_t root_ = 0;
};

} // namespace

UrdfChain urdfChain(const UrdfTree& tree, const std::string& tip, const std::string& base,
                    const std::string& where) {
  return Tree(tree, where).chain(tip, base);
}

std::vector<std::string> urdfTips(const UrdfTree& tree, const std::string& where) {
  return Tree(tree, where).tips();
}

} // namespace voluta::robot
