#version 450
// The depth pass of the item buffer writes no colour.

void main() {}
