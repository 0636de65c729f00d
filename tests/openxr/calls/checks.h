#pragma once
#include <openxr/openxr.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace test_runtime {

/// Ends a call with a result. Thrown only within the runtime: what the program calls catches it
/// (runtime.cpp).
struct Ended {
    XrResult result;
};

/// The function that the program has called on this thread.
void set_current_call(const char* name);
const char* current_call();

/// Records that the program breaks the specification. The call goes on.
void breach(std::string_view what);
/// The call ends with what a runtime returns for this.
[[noreturn]] void breach(XrResult error, std::string_view what);
inline void require(bool holds, XrResult error, std::string_view what) {
    if (!holds) breach(error, what);
}

using Types = std::initializer_list<XrStructureType>;

/// Of a structure that the program passes: that it is there, of this type, and followed by known ones only.
void check_struct(const void* value, XrStructureType type, Types known_next = {});
/// The same of several, with the size of one.
void check_structs(const void* values, std::size_t size, std::size_t count, XrStructureType type,
                   Types known_next = {});

/// The structure of this type among those that follow; null if there is none.
const void* next_of_type(const void* next, XrStructureType type);

/// A text in an array of fixed size: that it ends, and is not empty.
std::string checked_text(const char* text, std::size_t size, XrResult error, const char* what);

/// Sets the count, and whether values are asked for, for which there must be room.
bool asks_for_values(uint32_t capacity, uint32_t* count, const void* out, std::size_t available);

template <class T>
XrResult fill(uint32_t capacity, uint32_t* count, T* out, const std::vector<T>& values) {
    if (asks_for_values(capacity, count, out, values.size())) std::copy(values.begin(), values.end(), out);
    return XR_SUCCESS;
}
XrResult fill(uint32_t capacity, uint32_t* count, char* out, const std::string& text);

/// Each of `n` structures that the program provides with its type is filled by `write`.
template <class T, class Write>
XrResult fill_structs(uint32_t capacity, uint32_t* count, T* out, std::size_t n, XrStructureType type,
                      Write write) {
    if (!asks_for_values(capacity, count, out, n)) return XR_SUCCESS;
    check_structs(out, sizeof(T), n, type);
    for (std::size_t i = 0; i < n; ++i) write(out[i], i);
    return XR_SUCCESS;
}

/// The name of a structure, or its number.
std::string type_name(XrStructureType type);

}  // namespace test_runtime
