"""A server by which an agent reads, corrects and reconstructs drawings: `gaussiancad mcp`.

It speaks the Model Context Protocol over standard input and output, and works inside one folder.
"""
