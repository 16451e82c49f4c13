// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_EXPECT_ERROR_HPP
#define OPENCV_TEST_GMLPNP_EXPECT_ERROR_HPP

#include "test_precomp.hpp"

#include <functional>
#include <string>

namespace opencv_test {

// Error code of what `call` throws, with its message; 0 where it throws nothing.
inline int errorCode(const std::function<void()>& call, std::string* message = nullptr)
{
    try {
        call();
    } catch (const cv::Exception& e) {
        if (message)
            *message = e.err;
        return e.code;
    }
    return 0;
}

// A call that must throw `code` and name `word` in its message.
inline void expectError(int code, const std::string& word, const std::function<void()>& call)
{
    std::string message;
    EXPECT_EQ(errorCode(call, &message), code) << word;
    EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
}

}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_EXPECT_ERROR_HPP
