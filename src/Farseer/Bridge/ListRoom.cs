using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Room of lists that many items come into at once, and leave again.</summary>
internal static class ListRoom
{
    /// <summary>A queue with room for more is given up once it has been worked off: a scene is loaded once.</summary>
    private const int LargestKept = 256;

    /// <summary>Up to here each is looked for by itself, which stops where it stands; all at once reads the whole list.</summary>
    private const int FewLeaving = 8;

    /// <summary>Makes room for many more items, no more than they need: by itself a list would double.</summary>
    public static void Expect<T>(List<T> list, int more)
    {
        if (more > list.Count && list.Count + more > list.Capacity)
        {
            list.Capacity = list.Count + more;
        }
    }

    /// <summary>
    /// True if so many leave a list that they are taken out at once: one by one each would be looked for, and would move all
    /// behind it. Where somebody is told of each, each leaves by itself all the same.
    /// </summary>
    public static bool AreMany(int leaving) => leaving > FewLeaving;

    /// <summary>Removes what has been worked off.</summary>
    public static void WorkedOff<T>(List<T> queue, int count)
    {
        queue.RemoveRange(0, count);
        if (queue.Count == 0 && queue.Capacity > LargestKept)
        {
            queue.Capacity = 0;
        }
    }
}
