// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_BEAM_H_
#define JPRIM_FLEXIBLE_BEAM_H_

#include "jprim/flexible/finite_element_model.h"

namespace jprim {

/// A straight uniform beam along x from the origin, in any consistent units (SI in brackets).
struct UniformBeam {
    double length = 0;           ///< [m]
    int elements = 0;            ///< of equal length; there is one node more
    double youngsModulus = 0;    ///< E [Pa]
    double shearModulus = 0;     ///< G [Pa]
    double density = 0;          ///< rho [kg/m^3]
    double area = 0;             ///< A [m^2]
    double secondMomentY = 0;    ///< I_y = Int(z^2 dA) [m^4]: bending in the xz plane, about y
    double secondMomentZ = 0;    ///< I_z = Int(y^2 dA) [m^4]: bending in the xy plane, about z
    double torsionConstant = 0;  ///< J_t of G J_t [m^4]; I_y + I_z for a circular section
    /// Shear correction factors of Timoshenko's theory, for shear along y and z (5/6 for a rectangle); 0
    /// leaves out the deformation by shear: Euler and Bernoulli's theory.
    double shearFactorY = 0;
    double shearFactorZ = 0;
};

/// Two-node elements with six freedoms a node: linear stretch and twist, cubic deflection. Stiffness is exact
/// for loads at the nodes. The mass matrix is consistent with the cubic deflection without shear; it carries
/// the polar inertia rho (I_y + I_z) of the twist and leaves out the rotary inertia of bending.
/// Node ids are 1 to elements + 1.
/// Source: J. S. Przemieniecki, Theory of Matrix Structural Analysis, 1968, chapters 5 and 11.
/// @throws Error for a property that is not positive (shear factors: negative) or not finite
FiniteElementModel makeFiniteElementModel(const UniformBeam& beam);

}  // namespace jprim

#endif
