# The models, in the order of menus and tables. Each is the file <id>.cpp of this folder with a function
# <id>_model() that returns its Model (chain.cpp: const Model& chain_model()).
set(STEPLAB_MODELS free oscillator chain mesh rope morse crystal)
