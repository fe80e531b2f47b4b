using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// Sines and cosines of many angles, found together, which takes a third of the time of one by one and gives the same bits.
/// </summary>
internal sealed unsafe class TurnTable
{
    private readonly Column<double> _angles = new Column<double>();
    private readonly Column<double> _sin = new Column<double>();
    private readonly Column<double> _cos = new Column<double>();

    public int Count { get; private set; }

    /// <summary>Forgets all angles and makes room for so many.</summary>
    public void Clear(int capacity)
    {
        Count = 0;
        _angles.EnsureCapacity(capacity + StableMath.Lanes);
        _sin.EnsureCapacity(capacity + StableMath.Lanes);
        _cos.EnsureCapacity(capacity + StableMath.Lanes);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(double angle) => _angles.Pointer[Count++] = angle;

    public void Find()
    {
        for (int i = Count; i % StableMath.Lanes != 0; i++)
        {
            _angles.Pointer[i] = 0;
        }

        for (int i = 0; i < Count; i += StableMath.Lanes)
        {
            StableMath.SinCos(_angles.Pointer + i, _sin.Pointer + i, _cos.Pointer + i);
        }
    }

    public double Sin(int index) => _sin.Pointer[index];

    public double Cos(int index) => _cos.Pointer[index];

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Filled(_angles, Count);
        s.Filled(_sin, Count);
        s.Filled(_cos, Count);
        Count = s.Value(Count);
    }
}
