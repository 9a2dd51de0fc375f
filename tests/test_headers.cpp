// Owner of the precompiled header of all test programs (tests/CMakeLists.txt).
int main() {}
