#pragma once
#include <openxr/openxr.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace test_runtime {

/// Ends a call with a result. Thrown only within the runtime, whose entry points catch it (runtime.cpp).
struct Ended {
    XrResult result;
};

/// The name of the function that the program has called on this thread.
void set_current_call(const char* name);
const char* current_call();

/// Records a violation of the specification by the program. The call continues.
void breach(std::string_view what);
/// Records a violation and ends the call with the result that a runtime returns for it.
[[noreturn]] void breach(XrResult error, std::string_view what);
inline void require(bool holds, XrResult error, std::string_view what) {
    if (!holds) breach(error, what);
}

using Types = std::initializer_list<XrStructureType>;

/// Checks that a structure passed by the program exists, has this type, and is followed only by known
/// structures.
void check_struct(const void* value, XrStructureType type, Types known_next = {});
/// Like check_struct(), for an array of structures. `size`: the size of one structure in bytes.
void check_structs(const void* values, std::size_t size, std::size_t count, XrStructureType type,
                   Types known_next = {});

/// The structure of this type in the `next` chain; null if there is none.
const void* next_of_type(const void* next, XrStructureType type);

/// The text in an array of fixed size; checks that the text is terminated and not empty.
std::string checked_text(const char* text, std::size_t size, XrResult error, const char* what);

/// Sets the count, and returns whether the program requests values. If it does, the capacity must be
/// sufficient.
bool asks_for_values(uint32_t capacity, uint32_t* count, const void* out, std::size_t available);

template <class T>
XrResult fill(uint32_t capacity, uint32_t* count, T* out, const std::vector<T>& values) {
    if (asks_for_values(capacity, count, out, values.size())) std::copy(values.begin(), values.end(), out);
    return XR_SUCCESS;
}
XrResult fill(uint32_t capacity, uint32_t* count, char* out, const std::string& text);

/// Fills `n` structures, whose type the program has set, with `write`.
template <class T, class Write>
XrResult fill_structs(uint32_t capacity, uint32_t* count, T* out, std::size_t n, XrStructureType type,
                      Write write) {
    if (!asks_for_values(capacity, count, out, n)) return XR_SUCCESS;
    check_structs(out, sizeof(T), n, type);
    for (std::size_t i = 0; i < n; ++i) write(out[i], i);
    return XR_SUCCESS;
}

/// The name of a structure's type, or its number.
std::string type_name(XrStructureType type);

}  // namespace test_runtime
