#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

/// Defines `variable` as the folder of a real dataset, or skips the test if it is missing. VANTAGE_DATASETS
/// is the folder with the datasets.
#define VANTAGE_DATASET(variable, name)                                                           \
    const char* variable##_root = std::getenv("VANTAGE_DATASETS");                                \
    const std::filesystem::path variable =                                                        \
        std::filesystem::path(variable##_root ? variable##_root : "../shared/datasets") / (name); \
    if (!std::filesystem::is_directory(variable)) GTEST_SKIP() << "no dataset at " << variable;   \
    static_assert(true)
