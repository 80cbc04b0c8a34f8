"""Whether what is called verified is the part: sources of drawings, and changes of them."""
