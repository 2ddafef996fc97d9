#ifdef MISSPELT
uint Twice(uint value)
{
    return valu * 2u;
}
#endif
