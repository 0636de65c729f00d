#include "tests/openxr/calls/checks.h"

#include <openxr/openxr_reflection.h>

#include <algorithm>
#include <cstring>

#include "tests/openxr/calls/record.h"

namespace test_runtime {
namespace {

thread_local const char* called = "";

const XrBaseInStructure* next_of(const void* value) {
    return static_cast<const XrBaseInStructure*>(value)->next;
}

}  // namespace

void set_current_call(const char* name) { called = name; }
const char* current_call() { return called; }

void breach(std::string_view what) { record_violation(called, std::string(what)); }

void breach(XrResult error, std::string_view what) {
    breach(what);
    throw Ended{error};
}

void check_struct(const void* value, XrStructureType type, Types known_next) {
    if (!value) breach(XR_ERROR_VALIDATION_FAILURE, type_name(type) + " is missing");
    const auto* const base = static_cast<const XrBaseInStructure*>(value);
    if (base->type != type)
        breach(XR_ERROR_VALIDATION_FAILURE,
               "the type is " + type_name(base->type) + " instead of " + type_name(type));
    for (const XrBaseInStructure* next = base->next; next; next = next->next)
        if (std::find(known_next.begin(), known_next.end(), next->type) == known_next.end())
            breach(XR_ERROR_VALIDATION_FAILURE,
                   type_name(next->type) + " is not allowed in the next chain of " + type_name(type));
}

void check_structs(const void* values, std::size_t size, std::size_t count, XrStructureType type,
                   Types known_next) {
    if (!values && count > 0) breach(XR_ERROR_VALIDATION_FAILURE, type_name(type) + " is missing");
    for (std::size_t i = 0; i < count; ++i)
        check_struct(static_cast<const char*>(values) + i * size, type, known_next);
}

const void* next_of_type(const void* next, XrStructureType type) {
    for (; next; next = next_of(next))
        if (static_cast<const XrBaseInStructure*>(next)->type == type) return next;
    return nullptr;
}

std::string checked_text(const char* text, std::size_t size, XrResult error, const char* what) {
    const void* const end = std::memchr(text, '\0', size);
    if (!end) breach(error, std::string(what) + " is not terminated");
    if (end == text) breach(error, std::string(what) + " is empty");
    return text;
}

bool asks_for_values(uint32_t capacity, uint32_t* count, const void* out, std::size_t available) {
    require(count, XR_ERROR_VALIDATION_FAILURE, "the output for the count is null");
    *count = uint32_t(available);
    if (capacity == 0) return false;
    if (capacity < available)
        breach(XR_ERROR_SIZE_INSUFFICIENT,
               "the capacity is " + std::to_string(capacity) + " instead of " + std::to_string(available));
    require(out, XR_ERROR_VALIDATION_FAILURE, "the capacity is not 0, but the output for the values is null");
    return true;
}

XrResult fill(uint32_t capacity, uint32_t* count, char* out, const std::string& text) {
    if (asks_for_values(capacity, count, out, text.size() + 1))
        std::copy_n(text.c_str(), text.size() + 1, out);
    return XR_SUCCESS;
}

std::string type_name(XrStructureType type) {
#define NAMED_TYPE(name, value) \
    case name:                  \
        return #name;
    switch (type) {
        XR_LIST_ENUM_XrStructureType(NAMED_TYPE);
        default:
            return "a structure of type " + std::to_string(int(type));
    }
#undef NAMED_TYPE
}

}  // namespace test_runtime
