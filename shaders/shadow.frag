// Draws depths only.
void main() {}
