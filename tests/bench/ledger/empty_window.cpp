// The least that a first picture can cost: a window of OpenGL 4.5, cleared and shown once. Prints the
// milliseconds from the process's start.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

/// According to the kernel.
double seconds_since_start() {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string field;
    double ticks = 0, up = 0;
    for (int i = 1; i <= 22 && stat >> field; ++i)
        if (i == 22) ticks = std::stod(field);
    uptime >> up;
    return up - ticks / double(::sysconf(_SC_CLK_TCK));
}

}  // namespace

int main() {
    if (!glfwInit()) return 1;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(1280, 720, "empty", nullptr, nullptr);
    if (!window) return 1;
    glfwMakeContextCurrent(window);
    glClearColor(0.1f, 0.1f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window);
    glFinish();
    std::printf("%.0f\n", 1000 * seconds_since_start());
    glfwTerminate();
}
