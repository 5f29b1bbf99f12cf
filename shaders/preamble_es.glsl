#version 300 es
#ifdef GL_OES_sample_variables
#extension GL_OES_sample_variables : enable
#endif
precision highp float;
precision highp int;
precision highp sampler2D;
