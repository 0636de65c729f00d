#pragma once
#include <cstdio>
// This header must follow <cstdio>, whose types it uses.
#include <jpeglib.h>

#include <csetjmp>

namespace vantage::codec {

/// The jump target for errors in libjpeg, whose error handler must not return. The function that calls
/// setjmp(jump) must have no destructors to run.
struct JpegFailure {
    jpeg_error_mgr errors;
    std::jmp_buf jump;
};

/// An error manager that prints nothing and jumps to `failure.jump`, which must be set before libjpeg is
/// called.
inline jpeg_error_mgr* jumping_errors(JpegFailure& failure) {
    jpeg_error_mgr* errors = jpeg_std_error(&failure.errors);
    errors->error_exit = [](j_common_ptr j) {
        std::longjmp(reinterpret_cast<JpegFailure*>(j->err)->jump, 1);
    };
    errors->output_message = [](j_common_ptr) {};
    return errors;
}

}  // namespace vantage::codec
