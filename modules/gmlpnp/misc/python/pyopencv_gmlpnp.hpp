// The names that OpenCV's generator of Python bindings gives to template types of our functions.
#ifdef HAVE_OPENCV_GMLPNP
typedef std::vector<cv::gmlpnp::Result> vector_Result;
#endif
