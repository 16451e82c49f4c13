// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_FIELDS_HPP
#define GMLPNP_PYTHON_FIELDS_HPP

#include <algorithm>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "docstrings.hpp"

namespace bindings {

/** The members of a plain struct as attributes, one add() each; its constructor with keywords, its text and its pickled
form follow from them. */
template <class Struct>
class Fields
{
public:
    Fields(const py::handle& scope, const char* name) : class_(scope, name, doc(name)), name_(name) {}

    template <class T>
    Fields& add(const char* name, T Struct::*member)
    {
        class_.def_property(
            name, [member](const Struct& self) { return toPython(self.*member); },
            [member, name](Struct& self, const py::object& value) { fromPython(value, name, self.*member); },
            doc(name_ + "." + name));
        names_.emplace_back(name);
        return *this;
    }

    //! After the last add().
    py::class_<Struct>& finish()
    {
        class_.def(py::init([name = name_, names = names_](const py::kwargs& values) {
            py::object self = py::cast(Struct());
            for (const auto& [key, value] : values)
                set(self, name, names, key, value);
            return self.cast<Struct>();
        }));
        class_.def(py::pickle(
            [names = names_](const py::object& self) {
                py::dict state;
                for (const std::string& field : names)
                    state[field.c_str()] = self.attr(field.c_str());
                return state;
            },
            [](const py::dict& state) {
                py::object self = py::cast(Struct());
                for (const auto& [key, value] : state)
                    py::setattr(self, key, value);
                return self.cast<Struct>();
            }));
        return class_;
    }

    const std::vector<std::string>& names() const { return names_; }

private:
    static void set(const py::object& self, const std::string& name, const std::vector<std::string>& names,
                    const py::handle& key, const py::handle& value)
    {
        const std::string field = py::str(key);
        if (std::find(names.begin(), names.end(), field) == names.end())
            throw py::type_error(name + "() has no option '" + field + "'");
        py::setattr(self, key, value);
    }

    py::class_<Struct> class_;
    std::string name_;
    std::vector<std::string> names_;
};

}  // namespace bindings

#endif  // GMLPNP_PYTHON_FIELDS_HPP
