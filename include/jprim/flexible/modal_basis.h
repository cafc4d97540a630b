// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_MODAL_BASIS_H_
#define JPRIM_FLEXIBLE_MODAL_BASIS_H_

#include <string>
#include <vector>

#include "jprim/flexible/finite_element_model.h"

namespace jprim {

/// A node of a structure, and how it moves with each mode: its displacement is Sum_k q_k translation[k], its
/// small rotation Sum_k q_k rotation[k].
struct ModalNode {
    int id = 0;
    SimTK::Vec3 position;                  ///< undeformed [length]
    std::vector<SimTK::Vec3> translation;  ///< of each mode [1/sqrt(mass)]
    std::vector<SimTK::Vec3> rotation;     ///< of each mode [1/(sqrt(mass) length)]
};

/// A free structure that deforms little, described by a few modes.
///
/// Every mode k has modal mass 1, so that its coordinate q_k is in sqrt(mass) length, stiffness
/// frequencies[k]^2, and moves neither the mass centre nor, to first order, the mean orientation:
/// Int(phi_k dm) = 0, Int(p x phi_k dm) = 0. All vectors are in the axes of the mesh; p is measured from the
/// mass centre. Units are whatever consistent ones the structure was given in.
struct ModalBasis {
    std::string name;  ///< appears in messages
    RigidBodyProperties rigid;
    std::vector<double> frequencies;  ///< circular [rad/time], ascending
    std::vector<ModalNode> nodes;     ///< of the mesh in its order, then points that hold sets of nodes
    std::vector<int> interfaces;      ///< ids of the nodes that are interfaces

    /// @name First-order inertia coupling
    ///@{
    /// J_k = Int(2 p.phi_k 1 - p ~phi_k - phi_k ~p) dm: how the inertia about the mass centre changes with
    /// q_k [sqrt(mass) length]. Symmetric.
    std::vector<SimTK::Mat33> inertiaChange;
    /// n_kl = Int(phi_k x phi_l dm) for k < l, in the order 01, 02, …, 12, … [1]; n_lk = -n_kl.
    std::vector<SimTK::Vec3> gyroscopic;
    ///@}

    int getNumModes() const { return int(frequencies.size()); }
    /// n_kl for any k and l.
    SimTK::Vec3 getGyroscopic(int k, int l) const;
    /// @throws Error if no node has this id
    const ModalNode& getNode(int id) const;
};

/// The same structure in other units: a length of 1 becomes lengthFactor, and so on.
ModalBasis convertUnits(const ModalBasis& basis, double lengthFactor, double massFactor, double timeFactor);

/// The same structure in a frame with its origin elsewhere and the same axes.
/// @param origin  the new frame's origin, in the old frame
ModalBasis moveOrigin(const ModalBasis& basis, const SimTK::Vec3& origin);

/// Writes a basis as text that reads back to the same numbers. docs/flexible.md describes the format.
/// @throws Error if the file cannot be written
void saveModalBasis(const ModalBasis& basis, const std::string& file);

/// Reads what saveModalBasis() wrote. @throws Error, naming file and line, if the file is of another kind or
/// version, cut off or changed
ModalBasis loadModalBasis(const std::string& file);

}  // namespace jprim

#endif
