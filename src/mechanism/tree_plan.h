// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_TREE_PLAN_H_
#define JPRIM_SRC_MECHANISM_TREE_PLAN_H_

#include <map>
#include <optional>
#include <vector>

#include "jprim/dataset/dataset.h"
#include "jprim/dataset/element_id.h"

/// @file
/// Which joints of a dataset become joint coordinates and which stay equations: a question about who is joined
/// to whom, which needs no mechanics.
namespace jprim {

/// What a part is free to do against the one that it hangs on. Frames are the markers' I and J:
///
/// | mobilizer | of | freedoms |
/// | --- | --- | --- |
/// | Free | nothing | 6 |
/// | Weld | FIXED; ATPOINT + ORIENTATION | 0 |
/// | Pin | REVOLUTE; ATPOINT + PARALLEL_AXES | turn about z |
/// | Slider | TRANSLATIONAL; INLINE + ORIENTATION | shift along z |
/// | Universal | UNIVERSAL; ATPOINT + PERPENDICULAR | turns about z_J, then z_I |
/// | Hooke | HOOKE | turns about y_J, then x_I |
/// | Cylinder | CYLINDRICAL; INLINE + PARALLEL_AXES | turn about and shift along z |
/// | Ball | SPHERICAL; ATPOINT | 3 turns |
/// | Planar | PLANAR; INPLANE + PARALLEL_AXES | turn about z, shifts along x_J and y_J |
/// | Translation | ORIENTATION | 3 shifts |
enum class MobilizerType { Free, Weld, Slider, Pin, Universal, Hooke, Cylinder, Ball, Planar, Translation };

/// What an element carries of a mobilizer's load on marker I, at I's origin: ATPOINT, INLINE and INPLANE have no
/// moment there, rotational primitives no force.
enum class LoadShare { Force, Moment, Both };

/// A JOINT or JPRIM that a mobilizer stands for.
struct PlannedElement {
    ElementId id;
    LoadShare share = LoadShare::Both;
    bool swapped = false;  ///< its I is the mobilizer's J
};

/// What moves a PART.
struct PlannedMobilizer {
    MobilizerType type = MobilizerType::Free;
    int part = 0;           ///< the PART that moves: its place in Dataset::parts
    int parent = -1;        ///< the one it hangs on; of a Free -1, which is ground
    int i = 0;              ///< the markers of the joint; of a Free 0
    int j = 0;              ///
    bool reversed = false;  ///< marker J is on the part that moves, I on its parent
    std::vector<PlannedElement> elements;
};

/// Where an element is that a mobilizer stands for.
struct TreePlace {
    const PlannedMobilizer* mobilizer;
    const PlannedElement* element;
};

/// What moves every PART but ground, after the one that it hangs on.
class TreePlan {
public:
    explicit TreePlan(std::vector<PlannedMobilizer> mobilizers);
    /// Places lead into it.
    TreePlan(const TreePlan&) = delete;
    TreePlan& operator=(const TreePlan&) = delete;

    [[nodiscard]] const std::vector<PlannedMobilizer>& getMobilizers() const { return m_mobilizers; }
    /// Nothing if the element is not in the tree: then it is equations.
    [[nodiscard]] std::optional<TreePlace> find(const ElementId& id) const;

private:
    const std::vector<PlannedMobilizer> m_mobilizers;
    std::map<ElementId, TreePlace> m_places;
};

/// A spanning tree of shortest paths from ground. JPRIMs between the same two markers are taken together as far
/// as the table above has them; which of two markers is I matters to INLINE and INPLANE only. Where a choice is
/// left, joints that leave fewer freedoms are in the tree, so that loops are closed with fewer equations; sliders before
/// hinges, which close plane loops with two; then the earlier in the dataset. Parts that nothing joins to ground hang on it free, or on one that does.
/// FLEX_BODYs and POINT_MASSes, and what is joined to them, are not in the tree.
TreePlan planTree(const Dataset& dataset);

/// Every PART free.
TreePlan planFreeParts(const Dataset& dataset);

/// Simbody's word: "Pin". A Hooke is a Universal.
const char* getSimbodyName(MobilizerType type);

}  // namespace jprim

#endif
