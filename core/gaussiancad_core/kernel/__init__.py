"""The geometry kernels behind one door: exact solids in OpenCASCADE, meshes in Open3D."""
