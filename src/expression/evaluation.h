// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_EVALUATION_H_
#define JPRIM_SRC_EXPRESSION_EVALUATION_H_

#include <vector>

#include "expression/program.h"

namespace jprim {

/// A workspace in which a Program is run again and again. All memory is taken at construction.
///
/// Derivatives are exact. With time: two derivatives along a given motion are one chain rule per operation.
/// With respect to the inputs: the chain rule backwards through the same operations. A library would not make
/// this shorter: CppAD records another tape for each branch taken, and takes memory while it does; Sacado comes
/// with all of Trilinos; and vectors of three are scalars to both.
///
/// Where a derivative does not exist it is that of the branch taken (MAX, MIN, IF, the ends of STEP), or
/// zero (ABS at 0, AINT at a jump, SQRT at 0): one that is not finite counts as zero. The norm of a zero vector
/// grows in any direction; its gradient is one of them, so that a constraint has a way out, and its derivatives
/// with time are zero. Branches not taken have no influence, even if they have no value. So a finite value comes with finite
/// derivatives, unless they are too large for a Real.
class Evaluation {
public:
    explicit Evaluation(Program program);

    const Program& getProgram() const { return m_program; }

    /// Supplies an input, in the numbering of ProgramBuilder. calcValue() needs the value alone. Inputs keep
    /// what they were given; at first they are zero.
    void setScalarInput(int input, const Taylor<SimTK::Real>& value);
    void setVectorInput(int input, const Taylor<SimTK::Vec3>& value);

    /// The angle [rad] near which the continuous angle k is sought, to within half a turn. At first zero.
    void setRememberedAngle(int k, SimTK::Real angle);

    /// The result, for scalars and for vectors.
    SimTK::Real calcValue();
    SimTK::Vec3 calcVectorValue();

    /// The result and its derivatives with time, if the inputs have theirs.
    Taylor<SimTK::Real> calcTaylor();
    Taylor<SimTK::Vec3> calcVectorTaylor();

    /// Switch k of the program, where the last calc… was; with derivatives if that had them.
    const Taylor<SimTK::Real>& getSwitch(int k) const {
        return m_registers.scalars[m_program.m_code->switches.at(k).value];
    }

    /// The derivatives of the scalar result with respect to all inputs, where the last calc… was.
    void calcGradient();
    SimTK::Real getScalarGradient(int input) const;
    const SimTK::Vec3& getVectorGradient(int input) const;
    /// True if the gradient depends on the direction that was chosen for the norm of a zero vector.
    bool isGradientChosen() const { return m_isGradientChosen; }

    /// The continuous angle k [rad] that the last calc… found.
    SimTK::Real getAngle(int k) const;

private:
    template <class Access>
    void run();
    // A step of the reverse sweep: adds what the gradient of what the instruction wrote means for its arguments.
    void accumulateAdjoints(const Instruction& instruction, SimTK::Real gradient);
    void accumulateAdjoints(const Instruction& instruction, const SimTK::Vec3& gradient);

    Program m_program;
    Registers m_registers;
    // Of the result with respect to each register.
    std::vector<SimTK::Real> m_scalarGradients;
    std::vector<SimTK::Vec3> m_vectorGradients;
    bool m_isGradientChosen = false;
};

}  // namespace jprim

#endif
