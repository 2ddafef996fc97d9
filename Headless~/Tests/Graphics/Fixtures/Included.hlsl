#ifndef INCLUDED
#define INCLUDED

uint Included()
{
    return 5u;
}

#endif
