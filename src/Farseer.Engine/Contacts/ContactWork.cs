using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>What the stages of a pass hand on to each other for a bundle: see <see cref="ContactStages"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct ContactWork
{
    /// <summary>
    /// Bundles that go through the stages together: with their bodies and what they hand on, four of sixteen lanes are some 20 KB of the
    /// nearest cache. Three took the same time, six 1.01 of a step, eight 1.017, twelve 1.04 and sixteen 1.06; of eight lanes eight took
    /// 1.009. A bit a vector of all of them fits an integer.
    /// </summary>
    public const int MostBundles = 4;

    private const int Lanes = ContactBundle.Lanes;
    private const int LineBytes = 64;

    /// <summary>Lanes of the shortest vectors there are.</summary>
    private const int LeastWidth = 4;

    /// <summary>Room for all of them, for what their bodies have moved, and to begin at a line.</summary>
    public const int Bytes = (MostBundles * (Columns + ContactMoved.Columns) * Lanes * sizeof(float)) + LineBytes;

    private const int Columns = 15;

    /// <summary>Velocities of the bodies.</summary>
    public fixed float VelocityAX[Lanes];
    public fixed float VelocityAY[Lanes];
    public fixed float SpinA[Lanes];
    public fixed float VelocityBX[Lanes];
    public fixed float VelocityBY[Lanes];
    public fixed float SpinB[Lanes];

    /// <summary>Normal arms turned along.</summary>
    public fixed float ArmA0[Lanes];
    public fixed float ArmB0[Lanes];
    public fixed float ArmA1[Lanes];
    public fixed float ArmB1[Lanes];

    /// <summary>What the block is to make 0; then what the points are pushed with; then what they rub with.</summary>
    public fixed float Value0[Lanes];
    public fixed float Value1[Lanes];

    /// <summary>Above 0 where a contact may be struck.</summary>
    public fixed float MayBlow[Lanes];

    /// <summary>Spins by blows; -0, which changes nothing, in lanes beside those that have one.</summary>
    public fixed float BlowA[Lanes];
    public fixed float BlowB[Lanes];

    /// <summary>What the bodies of the bundles have moved, behind the work of them all.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ContactMoved* Moved(ContactWork* first) => (ContactMoved*)(first + MostBundles);

    /// <summary>The first line in memory of <see cref="Bytes"/>.</summary>
    public static ContactWork* In(byte* memory) => (ContactWork*)(((ulong)memory + (LineBytes - 1)) & ~(ulong)(LineBytes - 1));

    /// <summary>The bit of a bundle's lane and of those beside it in a vector.</summary>
    public static ulong Bit(int bundle, int lane) => 1UL << Place(bundle, lane);

    /// <summary>Which one that is.</summary>
    public static int Place(int bundle, int lane) => (int)((uint)((bundle * Lanes) + lane) / LeastWidth);

    /// <summary>Puts velocities of both bodies down.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Keep(ContactWork* work, int lane, in WideVelocity a, in WideVelocity b)
    {
        KeepA(work, lane, a);
        KeepB(work, lane, b);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void KeepA(ContactWork* work, int lane, in WideVelocity a)
    {
        a.X.Store(work->VelocityAX + lane);
        a.Y.Store(work->VelocityAY + lane);
        a.W.Store(work->SpinA + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void KeepB(ContactWork* work, int lane, in WideVelocity b)
    {
        b.X.Store(work->VelocityBX + lane);
        b.Y.Store(work->VelocityBY + lane);
        b.W.Store(work->SpinB + lane);
    }

    /// <summary>The velocities as they were put down.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Take(ContactWork* work, int lane, out WideVelocity a, out WideVelocity b)
    {
        a.X = Wide.Load(work->VelocityAX + lane);
        a.Y = Wide.Load(work->VelocityAY + lane);
        a.W = Wide.Load(work->SpinA + lane);
        b.X = Wide.Load(work->VelocityBX + lane);
        b.Y = Wide.Load(work->VelocityBY + lane);
        b.W = Wide.Load(work->SpinB + lane);
    }
}

/// <summary>
/// What the bodies of a bundle have moved: used only where vectors have no more than <see cref="Numerics.MatrixTurn.MostLanes"/>.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct ContactMoved
{
    public const int Columns = 8;

    private const int Lanes = ContactBundle.Lanes;

    public fixed float AX[Lanes];
    public fixed float AY[Lanes];
    public fixed float ASin[Lanes];
    public fixed float ACos[Lanes];
    public fixed float BX[Lanes];
    public fixed float BY[Lanes];
    public fixed float BSin[Lanes];
    public fixed float BCos[Lanes];

    /// <summary>What a body has moved, from its first column on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDelta Take(float* columns)
    {
        WideDelta moved;
        moved.X = Wide.Load(columns);
        moved.Y = Wide.Load(columns + Lanes);
        moved.Sin = Wide.Load(columns + (2 * Lanes));
        moved.Cos = Wide.Load(columns + (3 * Lanes));
        return moved;
    }
}
