"""A result drawn again, laid over the sheet, and shown.

This room works on triangle meshes and needs no OpenGL: all pictures are cast ray by ray.
"""
