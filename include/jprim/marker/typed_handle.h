// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_TYPED_HANDLE_H_
#define JPRIM_MARKER_TYPED_HANDLE_H_

#include "SimTKsimbody.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// @throws Error that the element is none of this class
[[noreturn]] void throwNotInstance(const SimTK::Constraint& constraint, const char* className);
[[noreturn]] void throwNotInstance(const SimTK::Force& force, const char* className);

/// Simbody's downcast() for a handle class of jprim, of what isInstanceOf() says is one: from what
/// `matter.getConstraint(index)` or `forces.getForce(index)` returns back to the class.
///
///     if (AtPoint::isInstanceOf(constraint)) load = AtPoint::downcast(constraint).calcReactionOnI(state);
///
/// @tparam Handle  the class, which has isInstanceOf() and ClassName
/// @tparam Base    the class that it derives from
/// @tparam Root    SimTK::Constraint or SimTK::Force
template <class Handle, class Base, class Root>
class TypedHandle : public Base {
public:
    TypedHandle() = default;

    /// @throws Error if it is another kind of element
    static const Handle& downcast(const Root& element) {
        if (!Handle::isInstanceOf(element)) throwNotInstance(element, Handle::ClassName);
        return static_cast<const Handle&>(element);  // handles hold no data of their own
    }
    static Handle& updDowncast(Root& element) { return const_cast<Handle&>(downcast(element)); }

protected:
    using Base::Base;
};

template <class Handle, class Base>
using TypedConstraint = TypedHandle<Handle, Base, SimTK::Constraint>;
template <class Handle>
using TypedForce = TypedHandle<Handle, SimTK::Force::Custom, SimTK::Force>;

}  // namespace jprim

#endif
